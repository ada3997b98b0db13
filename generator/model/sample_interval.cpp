#include "generator/model/sample_interval.hpp"

#include <cstdint>
#include <variant>

namespace finemote::gen {

std::optional<Duration> sample_interval(const Device& device) {
  const auto& acquisition = device.type->acquisition;
  if (!acquisition || acquisition->interval_param.empty()) return acquisition ? acquisition->interval : std::nullopt;
  const Param* param = find_param(device.params, acquisition->interval_param);
  const auto* ns = param != nullptr ? std::get_if<std::int64_t>(&param->value) : nullptr;
  return ns != nullptr ? std::optional(nanoseconds(*ns)) : std::nullopt;
}

}  // namespace finemote::gen
