#include "generator/descriptor/link_fields.hpp"

#include "generator/descriptor/member.hpp"
#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace {

LinkField read_field(const Json& value) {
  return {value.at("name").get<std::string>(), value.at("type").get<std::string>(), value.value("count", 0U)};
}

}  // namespace

std::optional<std::vector<LinkField>> read_link_fields(const Json& owner, const char* member) {
  if (!owner.contains(member)) return {};
  return read_list<LinkField>(owner, member, read_field);
}

InterfaceTable shipped_interfaces(const std::string& schema_dir) {
  const std::string path = schema_dir + "/interfaces.json";
  const Json document = Json::parse(read_installed(path));
  InterfaceTable table;
  for (const auto& [name, interface] : document.at("interfaces").items())
    table[name] = {read_link_fields(interface, "state"), read_link_fields(interface, "command")};
  return table;
}

}  // namespace finemote::gen
