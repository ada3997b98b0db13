#include "generator/output/manifest.hpp"

#include <algorithm>
#include <filesystem>
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

/// A relative name in normal form without `..`: what generate itself could have written.
bool could_be_ours(const HashedFile& file) {
  const std::string& name = file.name;
  const bool is_plain = !name.empty() && name.front() != '/' && name.back() != '/' && name != "." &&
                        name.find('\\') == std::string::npos && name.find('\0') == std::string::npos;
  if (!is_plain || name == kManifestName) return false;
  const std::string normal = std::filesystem::path(name).lexically_normal().generic_string();
  return normal == name && name != ".." && name.rfind("../", 0) != 0;
}

}  // namespace

std::string manifest_text(const Manifest& manifest) {
  Json json{{"schema", kSchema}, {"tool", manifest.tool}, {"format", manifest.format}, {"robot", manifest.robot}};
  if (!manifest.options.empty()) json["options"] = manifest.options;
  json["inputs"] = file_list(manifest.inputs);
  json["outputs"] = file_list(manifest.outputs);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";  // names of files may be no UTF-8
}

std::optional<Manifest> parse_manifest(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return std::nullopt;
  try {
    if (json.at("schema").get<std::string>() != kSchema) return std::nullopt;
    Manifest manifest;
    manifest.tool = json.at("tool").get<std::string>();
    manifest.format = json.at("format").get<int>();
    manifest.robot = json.at("robot").get<std::string>();
    if (json.contains("options")) manifest.options = json.at("options").get<std::vector<std::string>>();
    manifest.inputs = read_list(json.at("inputs"));
    manifest.outputs = read_list(json.at("outputs"));
    if (!std::all_of(manifest.outputs.begin(), manifest.outputs.end(), could_be_ours)) return std::nullopt;
    return manifest;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace finemote::gen
