#include "generator/descriptor/link_fields.hpp"

#include <fstream>
#include <stdexcept>

#include "generator/descriptor/member.hpp"

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
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  const Json document = Json::parse(file);
  InterfaceTable table;
  for (const auto& [name, interface] : document.at("interfaces").items())
    table[name] = {read_link_fields(interface, "state"), read_link_fields(interface, "command")};
  return table;
}

}  // namespace finemote::gen
