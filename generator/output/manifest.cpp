#include "generator/output/manifest.hpp"

#include <nlohmann/json.hpp>

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kSchema = "finemote.manifest/1";

Json file_list(const std::vector<HashedFile>& files) {
  Json list = Json::array();
  for (const HashedFile& file : files) list.push_back({{"name", file.name}, {"sha256", file.sha256}});
  return list;
}

std::vector<HashedFile> read_list(const Json& list) {
  std::vector<HashedFile> files;
  for (const Json& entry : list) {
    files.push_back({entry.at("name").get<std::string>(), entry.at("sha256").get<std::string>()});
  }
  return files;
}

/// A relative name without `..`: what generate itself could have written.
bool stays_inside(const std::string& name) {
  if (name.empty() || name.front() == '/' || name.find('\\') != std::string::npos) return false;
  return ("/" + name + "/").find("/../") == std::string::npos;
}

}  // namespace

std::string manifest_text(const Manifest& manifest) {
  const Json json{{"schema", kSchema},
                  {"tool", manifest.tool},
                  {"format", manifest.format},
                  {"robot", manifest.robot},
                  {"inputs", file_list(manifest.inputs)},
                  {"outputs", file_list(manifest.outputs)}};
  return json.dump(2) + "\n";
}

std::optional<Manifest> parse_manifest(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object() || json.value("schema", "") != kSchema) return std::nullopt;
  try {
    Manifest manifest;
    manifest.tool = json.at("tool").get<std::string>();
    manifest.format = json.at("format").get<int>();
    manifest.robot = json.at("robot").get<std::string>();
    manifest.inputs = read_list(json.at("inputs"));
    manifest.outputs = read_list(json.at("outputs"));
    for (const HashedFile& file : manifest.outputs) {
      if (!stays_inside(file.name)) return std::nullopt;
    }
    return manifest;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace finemote::gen
