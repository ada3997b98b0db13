#include "emulator/scenario/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "emulator/scenario/values.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::scenario {
namespace {

namespace code = gen::code;
using gen::json::Value;

double figure(const Value& entry, const char* key, double usual) {
  const Value* value = entry.find(key);
  return value != nullptr && value->is(Value::Kind::number) ? number_of(*value) : usual;
}

void check_pulses(const Value& entry, gen::Diagnostics& diagnostics) {
  const double neutral = figure(entry, "neutral", 1'500'000), min = figure(entry, "min", 1'100'000),
               max = figure(entry, "max", 1'900'000);
  if (min <= neutral && neutral <= max) return;
  const Value* word = entry.find("neutral");
  if (word == nullptr) word = entry.find(min > neutral ? "min" : "max");
  diagnostics
      .error(code::scenario_range, word->at,
             fmt::format("'neutral' is {} ns, but has to be between 'min', {} ns, and 'max', {} ns", neutral, min, max))
      .underline(word->length);
}

/// Six numbers that are the inertia of something.
void check_inertia(const Value& entry, const Model& model, gen::Diagnostics& diagnostics) {
  const Value* word = entry.find("inertia");
  const bool has_six = word != nullptr && word->items.size() == 6;
  if (!has_six) return;
  std::vector<double> i;
  for (const Value& item : word->items) i.push_back(item.is(Value::Kind::number) ? number_of(item) : 1);
  const double determinant =
      i[0] * (i[3] * i[5] - i[4] * i[4]) - i[1] * (i[1] * i[5] - i[4] * i[2]) + i[2] * (i[1] * i[4] - i[3] * i[2]);
  const double turns_with = model.type == "mecanum_base" ? i[5] : determinant;  // a base on wheels only yaws
  if (turns_with > 0) return;
  diagnostics.error(code::scenario_range, word->at, "a body with this 'inertia' cannot turn: it has to be above zero")
      .hint("\"inertia\": [0.1, 0, 0, 0.1, 0, 0.1]");
}

void check_channel(const Value& entry, const char* expander, gen::Diagnostics& diagnostics) {
  if (entry.find(expander) == nullptr || entry.find("channel") != nullptr) return;
  diagnostics.error(code::bad_scenario, entry.find(expander)->at, fmt::format("'channel' of '{}' is missing", expander))
      .underline(entry.find(expander)->length)
      .hint("\"channel\": 0");
}

}  // namespace

void check_figures(const Value& entry, const Model& model, gen::Diagnostics& diagnostics) {
  for (const char* expander : {"mux", "pwm"}) check_channel(entry, expander, diagnostics);
  if (model.type == "thruster") check_pulses(entry, diagnostics);
  check_inertia(entry, model, diagnostics);
}

}  // namespace finemote::scenario
