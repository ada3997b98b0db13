#include "generator/model/conversion.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// As the keys of a descriptor spell a value.
std::string key_of(const ParamValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return {};
}

}  // namespace

Duration conversion_time(const Device& device) {
  const auto& acquisition = device.type->acquisition;
  if (!acquisition || acquisition->model != Acquisition::Model::polled || !acquisition->conversion)
    return Duration::zero();
  const Conversion& conversion = *acquisition->conversion;
  const auto param = std::find_if(device.params.begin(), device.params.end(), [&](const Param& p) {
    return p.spec != nullptr && !conversion.param.empty() && p.spec->name == conversion.param;
  });
  if (param == device.params.end()) return conversion.longest();
  const auto known = conversion.by_value.find(key_of(param->value));
  return known == conversion.by_value.end() ? conversion.longest() : known->second;
}

}  // namespace finemote::gen
