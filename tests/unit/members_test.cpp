// Every member that a schema of descriptors and board files allows is read in one place, or is documentation: then no
// member is forgotten, and no two readers of one member disagree.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;
using Json = nlohmann::ordered_json;

namespace {

const fs::path kSource = finemote::test::source_dir();

/// The files that make types of JSON. Checks and repairs speak of members only to find their place in the text.
std::string reader_sources() {
  std::string text;
  for (const auto& entry : fs::directory_iterator(kSource / "generator/descriptor")) {
    const std::string name = entry.path().filename().string();
    const bool is_reader = name.rfind("check_", 0) != 0 && name != "repair.cpp" && name != "library.cpp";
    if (entry.path().extension() == ".cpp" && is_reader) text += read(entry.path());
  }
  return text;
}

/// How often each name is taken out of a JSON object: `at("x")`, `optional_member<T>(object, "x")`, `"x"` returned to
/// one of them.
std::map<std::string, int> reads() {
  const std::string text = reader_sources();
  const std::regex access(
      R"re((?:(?:\.|->)(?:at|find|value|contains)\(|\w+(?:<[\w:<>]+>)?\(\*?\w+,\s|(?:required|cost)\(|return |[?:] )"(\w+)")re");
  std::map<std::string, int> counts;
  for (std::sregex_iterator match(text.begin(), text.end(), access), end; match != end; ++match) ++counts[(*match)[1]];
  return counts;
}

/// The names a document of `schema` may have, each with the ways to it; what a `$ref` stands for goes once.
class Members {
 public:
  explicit Members(const std::string& name) : root_(Json::parse(read(kSource / "schemas" / (name + ".schema.json")))) {
    note(root_, name);
    const Json definitions = root_.value("definitions", Json::object());
    for (const auto& [key, definition] : definitions.items()) note(definition, name + "#" + key);
  }

  std::map<std::string, std::vector<std::string>> ways;

 private:
  [[nodiscard]] bool is_documentation(const Json& schema) const {
    std::string said = schema.value("description", std::string());
    const std::string target = schema.value("$ref", std::string());
    if (said.empty() && !target.empty()) {
      const std::size_t hash = target.find('#');
      const Json other = hash == 0 ? Json() : Json::parse(read(kSource / "schemas" / target.substr(0, hash)));
      const Json& definition = (hash == 0 ? root_ : other).at(Json::json_pointer(target.substr(hash + 1)));
      said = definition.value("description", std::string());
    }
    return said.rfind("Documentation", 0) == 0;
  }
  void note(const Json& schema, const std::string& way) {
    if (!schema.is_object() || is_documentation(schema)) return;
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [name, member] : properties.items()) {
      if (!member.is_object() || is_documentation(member)) continue;
      ways[name].push_back(way + "/" + name);
      note(member, way + "/" + name);
    }
    for (const char* below : {"items", "additionalProperties"}) {
      if (schema.contains(below)) note(schema.at(below), way);
    }
  }

  Json root_;
};

}  // namespace

TEST_CASE("every member of a descriptor or board file is read in one place, or is documentation") {
  const auto counts = reads();
  std::map<std::string, std::vector<std::string>> ways;
  for (const char* name : {"device", "expander", "board"}) {
    for (const auto& [member, found] : Members(name).ways)
      ways[member].insert(ways[member].end(), found.begin(), found.end());
  }
  CHECK(ways.size() > 80);
  ways["command"].push_back("interfaces/command");  // schemas/interfaces.json, which has no schema
  // The library compares these before anything is read.
  for (const char* name : {"schema", "extends"}) ways.erase(name);
  CHECK(read(kSource / "emulator/program/onboard_parts.cpp").find("\"on_board\"") != std::string::npos);
  ways.erase("on_board");  // what hangs on an emulated board is of no use to a robot
  for (const auto& [member, found] : ways) {
    INFO("'" << member << "', in " << Json(found).dump());
    const auto count = counts.find(member);
    CHECK(count != counts.end());
    if (count != counts.end()) CHECK(static_cast<std::size_t>(count->second) <= found.size());
  }
}

TEST_CASE("no type hands JSON to those who do not read descriptors") {
  for (const char* type : {"board", "device_type"}) {
    INFO(type);
    CHECK(read(kSource / "generator/descriptor" / (std::string(type) + ".hpp")).find("nlohmann") == std::string::npos);
  }
}
