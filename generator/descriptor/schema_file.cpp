#include "generator/descriptor/schema_file.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "generator/descriptor/json_file.hpp"
#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace {

struct SchemaFile {
  std::string text;
  Json value;
};

std::optional<SchemaFile> read_one(const std::filesystem::path& path, Diagnostics& diagnostics) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  SchemaFile schema{text.str(), Json::parse(text.str(), nullptr, /*allow_exceptions*/ false)};
  if (schema.value.is_object()) return schema;
  diagnostics.error(code::data_not_found, {}, DamagedInstallation(path.generic_string()).what()).hint(kInstallAgain);
  return {};
}

/// Makes every reference to another file one to the schema itself; the files are added to `others`.
void localise(Json& node, std::set<std::string>& others) {
  for (auto& [key, value] : node.items()) {
    if (value.is_structured()) localise(value, others);
    const std::string target = key == "$ref" && value.is_string() ? value.get<std::string>() : "#";
    const std::size_t end = target.find('#');
    if (end == 0 || end == std::string::npos) continue;
    others.insert(target.substr(0, end));
    value = target.substr(end);
  }
}

}  // namespace

std::optional<std::string> read_schema(const std::string& folder, const std::string& file, Diagnostics& diagnostics) {
  auto schema = read_one(std::filesystem::path(folder) / file, diagnostics);
  if (!schema) return {};
  std::set<std::string> others;
  localise(schema->value, others);
  if (others.empty()) return schema->text;
  Json& own = schema->value["definitions"];
  for (const std::string& name : others) {
    const auto other = read_one(std::filesystem::path(folder) / name, diagnostics);
    if (!other) return {};
    const Json definitions = other->value.value("definitions", Json::object());
    for (const auto& [key, definition] : definitions.items()) {
      if (!own.contains(key)) own[key] = definition;
    }
  }
  return schema->value.dump(2) + "\n";
}

}  // namespace finemote::gen
