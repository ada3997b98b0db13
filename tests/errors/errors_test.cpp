// Every case of this folder: what the tool says of it is exactly what stands in the file beside it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/model/build.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = FINEMOTE_SOURCE_DIR;
const fs::path kFolder = kSource / "tests" / "errors";

/// `FM3012_unknown_port.urdf`, or a folder `FM3101_malformed` with `robot.urdf`, `devices/` and `boards/`.
struct Case {
  std::string name;  ///< without suffix
  fs::path input;
  fs::path folder;
  fs::path expected;
  std::string display;
};

std::set<std::string> case_names() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.is_directory() || entry.path().extension() == ".urdf") names.insert(entry.path().stem().string());
  }
  return names;
}

Case find_case(const std::string& name) {
  const fs::path folder = kFolder / name;
  if (fs::is_directory(folder)) return {name, folder / "robot.urdf", folder, folder / "expected", "robot.urdf"};
  return {name, kFolder / (name + ".urdf"), kFolder, kFolder / (name + ".expected"), name + ".urdf"};
}

/// What the tool says of a case, as text; it never makes a robot of it.
std::string say(const Case& test) {
  Sources sources;
  Diagnostics diagnostics;
  LibraryOptions options{kSource.string(), test.folder.string(), {}, {}};
  if (fs::is_directory(test.folder / "boards")) options.board_paths.push_back((test.folder / "boards").string());
  auto library = load_library(options, sources, diagnostics);
  const SourceFile* file = xml::read_source(test.input.string(), sources, diagnostics, test.display);
  if (library && file != nullptr) {
    const auto document = xml::parse(*file, diagnostics);
    if (document) build_model(*document, *library, {}, sources, diagnostics);
    CHECK(diagnostics.has_errors());
  }
  return render_text(diagnostics, false);
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool is_updating() {
  const char* wish = std::getenv("FINEMOTE_UPDATE_GOLDEN");
  return wish != nullptr && std::string(wish) == "1";
}

}  // namespace

TEST_CASE("every mistake is explained where it stands") {
  const auto names = case_names();
  REQUIRE(names.size() > 80);
  for (const std::string& name : names) {
    const Case test = find_case(name);
    DYNAMIC_SECTION(name) {
      const std::string said = say(test);
      if (name.substr(0, 2) == "FM") CHECK(said.find("error[" + name.substr(0, 6) + "]") != std::string::npos);
      if (is_updating() && read(test.expected) != said) std::ofstream(test.expected, std::ios::binary) << said;
      CHECK(said == read(test.expected));
    }
  }
}

TEST_CASE("findings come in file order") {
  for (const std::string& name : case_names()) {
    const Case test = find_case(name);
    std::istringstream said(say(test));
    std::size_t last = 0;
    for (std::string line; std::getline(said, line);) {
      if (line.rfind(test.display + ":", 0) != 0) continue;
      const std::size_t number = std::strtoul(line.c_str() + test.display.size() + 1, nullptr, 10);
      INFO(line);
      CHECK(number >= last);
      last = number;
    }
  }
}
