// One table of faults: what the runtime counts is in schemas/faults.json, what stops the firmware is refused by a
// diagnostic or says why not, and docs/reference/faults.md shows that table. FINEMOTE_UPDATE_GOLDEN=1 rewrites it
// there.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "catch.hpp"
#include "read.hpp"
#include "source_dir.hpp"
#include "tests/rewrites.hpp"

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using finemote::test::read;

namespace {

const fs::path kSource = finemote::test::source_dir();

std::vector<std::string> matches(const std::string& text, const std::string& pattern, int group) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.push_back((*match)[static_cast<std::size_t>(group)]);
  return found;
}

/// Enumerators of the bodies of an enumeration, with their values.
std::map<std::string, unsigned> enumerators(std::string body) {
  body = std::regex_replace(body, std::regex("//[^\n]*"), "");
  std::map<std::string, unsigned> values;
  unsigned next = 0;
  const std::regex entry(R"((\w+)(?:\s*=\s*(\d+))?\s*(?:,|$))");
  for (std::sregex_iterator match(body.begin(), body.end(), entry), end; match != end; ++match) {
    if ((*match)[2].matched) next = static_cast<unsigned>(std::stoul((*match)[2]));
    values[(*match)[1]] = next++;
  }
  return values;
}

std::map<std::string, unsigned> enumerators_of(const std::string& text, const std::string& name) {
  std::map<std::string, unsigned> values;
  for (const std::string& body : matches(text, "enum (?:class )?" + name + R"( : std::uint8_t \{([^}]*)\})", 1)) {
    for (const auto& [enumerator, value] : enumerators(body)) values[enumerator] = value;
  }
  return values;
}

std::string all_sources() {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "runtime")) {
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") text += read(entry.path()) + "\n";
  }
  return text;
}

const std::string kRuntime = all_sources();
const Json kFaults = Json::parse(read(kSource / "schemas/faults.json")).at("faults");

/// `UartFault` -> `uart`.
std::string module_of(std::string name) {
  name.resize(name.size() - std::string("Fault").size());
  for (char& c : name) c = static_cast<char>(std::tolower(c));
  return name;
}

const Json* row_of(const std::string& module, unsigned number) {
  for (const Json& fault : kFaults) {
    if (fault.at("name") == module && fault.value("number", number) == number) return &fault;
  }
  return nullptr;
}

std::set<std::string> fault_enumerations() {
  const auto names = matches(kRuntime, R"(enum (?:class )?(\w+Fault) :)", 1);
  return {names.begin(), names.end()};
}

std::string cell(const std::string& text) { return text.empty() ? " |" : " " + text + " |"; }

std::string made_table() {
  std::string text = "| module | number | what | effect | refused before it runs |\n|---|---|---|---|---|\n", last;
  for (const Json& fault : kFaults) {
    const auto module = fault.at("name").get<std::string>();
    const std::string number = fault.contains("number") ? fault.at("number").dump() : "index";
    const std::string before = std::regex_replace(fault.value("before", std::string()), std::regex(R"(FM(\d{4}))"),
                                                  "[$&](../diagnostics/$&.md)");
    text += "|" + cell(module == last ? "" : module + " (" + fault.at("module").dump() + ")") + cell(number) +
            cell(fault.at("what").get<std::string>()) + cell(fault.at("effect").get<std::string>()) + cell(before) +
            "\n";
    last = module;
  }
  return text;
}

}  // namespace

TEST_CASE("every fault of the runtime has a row, and every row is a fault") {
  const auto modules = enumerators_of(kRuntime, "Module");
  std::set<std::pair<std::string, unsigned>> counted;
  const auto enumerations = fault_enumerations();
  REQUIRE(enumerations.size() >= 9);
  for (const std::string& name : enumerations) {
    const auto faults = enumerators_of(kRuntime, name);
    CHECK(!faults.empty());
    for (const auto& [enumerator, number] : faults) {
      INFO(name << "::" << enumerator << " = " << number);
      CHECK(row_of(module_of(name), number) != nullptr);
      counted.insert({module_of(name), number});
    }
  }
  for (const Json& fault : kFaults) {
    INFO(fault.dump());
    if (fault.at("module") == 0) continue;  // those that found no record: faults_lost()
    REQUIRE(modules.count(fault.at("name")) == 1);
    CHECK(modules.at(fault.at("name")) == fault.at("module"));
    if (fault.contains("number")) CHECK(counted.count({fault.at("name"), fault.at("number")}) == 1);
  }
}

TEST_CASE("what stops the firmware is refused before it runs, or the table says why not") {
  std::size_t stops = 0;
  const std::regex stop(
      R"((?:stop_safely\(\s*Module::\w+,\s*static_cast<std::uint8_t>\(|refuse\(|fail\()(\w+Fault)::(\w+))");
  for (std::sregex_iterator match(kRuntime.begin(), kRuntime.end(), stop), end; match != end; ++match) {
    const std::string name = (*match)[1], enumerator = (*match)[2];
    INFO(name << "::" << enumerator);
    const Json* row = row_of(module_of(name), enumerators_of(kRuntime, name).at(enumerator));
    REQUIRE(row != nullptr);
    CHECK((row->value("stops", false) || row->value("overrun", false)));
    ++stops;
  }
  CHECK(stops >= 15);
  for (const Json& fault : kFaults) {
    INFO(fault.dump());
    if (fault.value("stops", false)) REQUIRE(fault.contains("before"));
    const std::string before = fault.value("before", std::string("no: it is survived"));
    const auto codes = matches(before, R"(FM\d{4})", 0);
    CHECK((before.rfind("no: ", 0) == 0 || !codes.empty()));
    for (const std::string& code : codes) CHECK(fs::exists(kSource / "docs/diagnostics" / (code + ".md")));
  }
}

TEST_CASE("the page of the faults shows the table") {
  const fs::path path = kSource / "docs/reference/faults.md";
  std::string page = read(path);
  const auto begin = page.find("| module | number |"), end = page.find("\n\n", begin);
  REQUIRE(end != std::string::npos);
  if (finemote::test::rewrites()) {
    page.replace(begin, end + 1 - begin, made_table());
    std::ofstream(path, std::ios::binary) << page;
    return;
  }
  CHECK(page.substr(begin, end + 1 - begin) == made_table());
}
