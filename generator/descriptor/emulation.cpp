#include "generator/descriptor/emulation.hpp"

#include <nlohmann/json.hpp>

#include "generator/descriptor/member.hpp"

namespace finemote::gen {

Emulation read_emulation(const Json& value) {
  Emulation emulation;
  emulation.part = value.value("part", std::string());
  emulation.params = value.value("params", std::vector<std::string>());
  if (const auto it = value.find("values"); it != value.end()) emulation.values = std::make_shared<const Json>(*it);
  emulation.body = value.value("body", std::string());
  emulation.wheels = value.value("wheels", std::string());
  return emulation;
}

}  // namespace finemote::gen
