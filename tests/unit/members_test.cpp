// A member that a schema allows has an effect: the generator reads it, or its description says that it is
// documentation.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "read.hpp"

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using finemote::test::read;

namespace {

const fs::path kSource = FINEMOTE_SOURCE_DIR;

std::string generator_sources() {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "generator")) {
    if (entry.path().extension() == ".cpp") text += read(entry.path());
  }
  return text;
}

bool is_documentation(const Json& schema) {
  return schema.value("description", std::string()).rfind("Documentation", 0) == 0;
}

/// `state_fields` and `command_fields`: emit/link.cpp puts these names together.
bool is_fields(const std::string& name) { return name == "state_fields" || name == "command_fields"; }

/// Names below `schema` that nobody reads, each with the way to it.
void find_unread(const Json& schema, const std::string& path, const std::string& sources,
                 std::vector<std::string>& unread) {
  if (!schema.is_object() || is_documentation(schema)) return;
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [name, member] : properties.items()) {
    const bool is_read = sources.find('"' + name + '"') != std::string::npos || is_fields(name);
    if (!is_read && !is_documentation(member)) unread.push_back(path + "/" + name);
    find_unread(member, path + "/" + name, sources, unread);
  }
  for (const char* below : {"items", "additionalProperties"}) {
    if (schema.contains(below)) find_unread(schema.at(below), path, sources, unread);
  }
  const Json definitions = schema.value("definitions", Json::object());
  for (const auto& [name, definition] : definitions.items())
    find_unread(definition, path + "#" + name, sources, unread);
}

}  // namespace

TEST_CASE("every member of a descriptor or board file is read, or is documentation") {
  const std::string sources = generator_sources();
  for (const char* name : {"device", "expander", "board"}) {
    INFO(name);
    std::vector<std::string> unread;
    find_unread(Json::parse(read(kSource / "schemas" / (std::string(name) + ".schema.json"))), "", sources, unread);
    CHECK(unread == std::vector<std::string>{});
  }
}
