// The catalogue is complete: every number has a page that explains it, a case that produces it, and a line that reports
// it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "catch.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"
#include "read.hpp"
#include "source_dir.hpp"
#include "tests/rewrites.hpp"

using namespace finemote::gen;
using finemote::test::read;
namespace fs = std::filesystem;

namespace {

const std::string kSource = finemote::test::source_dir();
const std::string kPages = kSource + "/docs/diagnostics";

/// Name -> number of every constant in code.hpp and its parts.
std::map<std::string, int> declared_codes() {
  const fs::path folder = fs::path(kSource) / "generator/diagnostic";
  std::string text;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind("code", 0) == 0) text += read(entry.path());
  }
  const std::regex declaration(R"(inline constexpr Code (\w+)\{(\d+)\})");
  std::map<std::string, int> codes;
  for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match) {
    codes[(*match)[1]] = std::stoi((*match)[2]);
  }
  return codes;
}

/// Where the cases lie, each named after the number it produces; the tests of these folders check that it does.
const char* const kExampleFolders[] = {"tests/errors", "tests/command_output"};

std::set<int> example_codes() {
  std::set<int> codes;
  for (const char* folder : kExampleFolders) {
    for (const auto& entry : fs::directory_iterator(fs::path(kSource) / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("FM", 0) == 0 && name.size() > 6) codes.insert(std::stoi(name.substr(2, 4)));
    }
  }
  return codes;
}

/// Numbers without an example, each with the reason.
const std::map<int, std::string> kWithoutExample{
    {2016, "the numbers read are checked before they are computed with; constants_test writes one that no float holds"},
    {6101, "the build makes images that can be read; image_test cuts and disturbs one"},
    {9001, "a defect of the tool: an input that led there would be mended"},
};

/// `#include "..."` lines name constants; only uses count.
bool is_used(const std::string& name) {
  const std::regex use("code::" + name + R"(\b)");
  for (const char* folder : {"generator", "emulator"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(kSource) / folder)) {
      const auto extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp") continue;
      const std::string text = read(entry.path());
      if (text.find("code::" + name) != std::string::npos && std::regex_search(text, use)) return true;
    }
  }
  return false;
}

struct Range {
  int first;
  const char* title;
};
constexpr Range kRanges[] = {{0, "Command line and files"},
                             {1000, "XML and xacro"},
                             {2000, "Links and joints of the URDF"},
                             {3000, "Devices, buses, boards, descriptors"},
                             {4000, "Timing"},
                             {5000, "Output and check"},
                             {6000, "Firmware and emulator"},
                             {9000, "Internal"}};

/// docs/diagnostics/README.md: all pages by range.
std::string index_page() {
  std::string text =
      "# Diagnostics\n\nEvery message of finemote carries one of these numbers. `finemote explain FM3012` prints a "
      "page "
      "from here;\n`finemote explain` prints this list. Numbers are never reused.\n";
  const char* title = nullptr;
  for (const CatalogueEntry& entry : list_catalogue(kPages)) {
    const Range* range = kRanges;
    for (const Range& candidate : kRanges) {
      if (candidate.first <= entry.code.number) range = &candidate;
    }
    if (title != range->title) text += std::string("\n## ") + range->title + "\n\n";
    title = range->title;
    const std::string name = code_name(entry.code);
    text += "- [" + name + "](" + name + ".md): " + entry.title + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("every number is used for one mistake") {
  std::set<int> seen;
  for (const auto& [name, number] : declared_codes()) {
    INFO(name);
    CHECK(seen.insert(number).second);
  }
  CHECK(seen.size() > 100);
}

TEST_CASE("every number has a page with title and explanation, and every page a number") {
  std::set<int> declared;
  for (const auto& [name, number] : declared_codes()) {
    declared.insert(number);
    const Code code{static_cast<std::uint16_t>(number)};
    INFO(name << " " << code_name(code));
    const std::string page = read(fs::path(kPages) / (code_name(code) + ".md"));
    CHECK(page.rfind("# " + code_name(code) + ": ", 0) == 0);
    const std::string body = page.substr(page.find('\n'));
    CHECK(body.find_first_not_of('\n') != std::string::npos);
    CHECK((body.find("Wrong:") == std::string::npos) == (body.find("Right:") == std::string::npos));
  }
  for (const CatalogueEntry& entry : list_catalogue(kPages)) {
    INFO(code_name(entry.code) << " " << entry.title);
    CHECK(declared.count(entry.code.number) == 1);
    CHECK_FALSE(entry.title.empty());
  }
}

TEST_CASE("every number is produced by some case") {
  const std::set<int> examples = example_codes();
  for (const auto& [name, number] : declared_codes()) {
    INFO(name << " " << number);
    CHECK((examples.count(number) == 1) != (kWithoutExample.count(number) == 1));
  }
  std::set<int> declared;
  for (const auto& [name, number] : declared_codes()) declared.insert(number);
  for (const int number : examples) {
    INFO("a case of a number that is not declared: " << number);
    CHECK(declared.count(number) == 1);
  }
}

TEST_CASE("every number is reported by some line of the tool") {
  for (const auto& [name, number] : declared_codes()) {
    INFO(name << " " << number);
    CHECK(is_used(name));
  }
}

TEST_CASE("the index of the pages is up to date") {
  const fs::path path = fs::path(kSource) / "docs/diagnostics/README.md";
  if (finemote::test::rewrites()) std::ofstream(path, std::ios::binary) << index_page();
  INFO("FINEMOTE_UPDATE_GOLDEN=1 writes it anew");
  CHECK(read(path) == index_page());
}

TEST_CASE("a code is found however it is written") {
  CHECK(parse_code("FM3012") == Code{3012});
  CHECK(parse_code("fm0001") == Code{1});
  CHECK(parse_code("3012") == Code{3012});
  CHECK_FALSE(parse_code("FM"));
  CHECK_FALSE(parse_code("FM30x2"));
  CHECK_FALSE(parse_code("FM030120"));
  CHECK_FALSE(parse_code(""));
}
