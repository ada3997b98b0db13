#include "generator/descriptor/check_emulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/descriptor/read_param.hpp"

namespace finemote::gen {
namespace {

/// Members of a part in a scenario that the robot gives, as generator/run/parts.cpp writes them.
constexpr std::array<std::string_view, 7> kOfRobot{"type", "name", "port", "mux", "pwm", "channel", "address"};

}  // namespace

void check_part_member(const std::string& name, const JsonPath& path, const Contradictions& found) {
  if (std::find(kOfRobot.begin(), kOfRobot.end(), name) != kOfRobot.end())
    found.add(path, fmt::format("'{}' of the emulated part is what the robot says of it", name));
}

void check_emulation(const Emulation& emulation, const std::vector<ParamSpec>& params, const Contradictions& found) {
  for (std::size_t i = 0; i < emulation.params.size(); ++i) {
    const std::string& name = emulation.params[i];
    const JsonPath path{"emulation", "params", std::to_string(i)};
    if (find_spec(params, name) == nullptr) found.add(path, fmt::format("there is no param '{}'", name));
    check_part_member(name, path, found);
  }
  if (emulation.values == nullptr) return;
  for (const auto& [name, value] : emulation.values->items())
    check_part_member(name, {"emulation", "values", name}, found);
}

}  // namespace finemote::gen
