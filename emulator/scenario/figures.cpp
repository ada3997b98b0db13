#include "emulator/scenario/figures.hpp"

#include <cmath>
#include <cstdlib>

#include "emulator/scenario/values.hpp"

namespace finemote::scenario {

using gen::json::Value;

std::optional<double> figure(const Value& entry, const Model& model, const char* key) {
  if (const Value* value = entry.find(key)) {
    const double number = value->is(Value::Kind::number) ? number_of(*value) : kAny;
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
  }
  const Member* row = find_member(model.figures, key);
  if (row == nullptr || row->usual.empty()) return std::nullopt;
  return std::strtod(row->usual.c_str(), nullptr);
}

const Value* word_in(const Value& entry, const char* key) {
  const Value* value = entry.find(key);
  return value != nullptr && value->is(Value::Kind::string) ? value : nullptr;
}

}  // namespace finemote::scenario
