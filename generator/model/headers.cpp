// Headers of the user's types that generated code includes by one name: FM3103 where they are two files, of which the
// compiler would take the first it finds for both.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

/// A type in use, and where it is named.
struct NamedHeader {
  const xml::Attribute* at;
  std::string type, include, include_dir;
};

std::vector<NamedHeader> user_types(const Reading& reading) {
  std::vector<NamedHeader> uses;
  const auto add = [&](const xml::Node& tag, const char* attribute, const auto* type) {
    const xml::Attribute* at = tag.attribute(attribute);
    if (type != nullptr && at != nullptr && !type->include_dir.empty())
      uses.push_back({at, at->value, type->include, type->include_dir});
  };
  for (const DeviceId i : reading.robot.devices.ids())
    add(reading.device_tag(i), "type", reading.robot.devices[i].type);
  for (const ExpanderId i : reading.robot.expanders.ids())
    add(*reading.tags.expanders[i], "model", reading.robot.expanders[i].type);
  return uses;
}

bool is_one_file(const NamedHeader& a, const NamedHeader& b) {
  std::error_code unknown;
  return a.include_dir == b.include_dir ||
         std::filesystem::equivalent(std::filesystem::path(a.include_dir) / a.include,
                                     std::filesystem::path(b.include_dir) / b.include, unknown);
}

}  // namespace

void check_headers(Reading& reading) {
  std::map<std::string, NamedHeader> first;  // by the name of the header
  std::set<std::string> reported;            // types
  for (const NamedHeader& use : user_types(reading)) {
    const auto [known, is_new] = first.emplace(use.include, use);
    if (is_new || is_one_file(known->second, use) || !reported.insert(use.type).second) continue;
    at_value(reading.diagnostics, code::descriptor_contradiction, *use.at,
             fmt::format("types '{}' and '{}' have different headers of the same name '{}'", known->second.type,
                         use.type, use.include))
        .note("generated code includes both by that name, and the compiler finds one of them")
        .hint("give one of them another name, for example that of its class");
  }
}

}  // namespace finemote::gen
