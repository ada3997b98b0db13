#include "emulator/scenario/place.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "emulator/scenario/values.hpp"

namespace finemote::scenario {
namespace {

using gen::json::Value;

std::string word_of(const Value& entry, const char* key) {
  const Value* value = entry.find(key);
  return value != nullptr && value->is(Value::Kind::string) ? value->text : "";
}

std::optional<int> number_in(const Value& entry, const char* key) {
  const Value* value = entry.find(key);
  if (value == nullptr || !value->is(Value::Kind::number)) return std::nullopt;
  const double number = number_of(*value);
  constexpr double kLargest = 1e9;
  return std::abs(number) <= kLargest ? std::optional(static_cast<int>(number)) : std::nullopt;
}

/// The kind of port a model is at; empty: at none.
std::string port_kind_of(const Model& model) {
  for (const Member& row : model.figures) {
    if (row.kind == Member::Kind::port) return row.choices[0];
  }
  return {};
}

/// The address of a part that does not say one, or that can have no other.
std::optional<int> address_of(const Value& entry, const Model& model) {
  constexpr int kMs5837 = 0x76;
  if (model.type == "ms5837") return kMs5837;
  if (const auto given = number_in(entry, "address")) return given;
  constexpr std::pair<const char*, int> kUsual[] = {{"tca9548a", 0x70}, {"pca9685", 0x40}, {"ist8310", 0x0E}};
  for (const auto& [type, address] : kUsual) {
    if (model.type == type) return address;
  }
  return std::nullopt;
}

void hold(Place& place, const Value& entry, const char* member, const char* words) {
  const auto number = number_in(entry, member);
  if (number && !place.port.empty())
    place.holds.push_back({fmt::format("{} {} of '{}'", words, *number, place.port), member});
}

/// An output turns one thing; a `pwm_output` only looks at it.
void hold_output(Place& place, const Value& entry) {
  const std::string expander = word_of(entry, "pwm");
  const auto channel = number_in(entry, "channel");
  if (!place.port.empty()) place.holds.push_back({fmt::format("the output '{}'", place.port), "port"});
  if (!expander.empty() && channel)
    place.holds.push_back({fmt::format("output {} of '{}'", *channel, expander), "channel"});
}

}  // namespace

Place place_of(const Value& entry, const Model& model) {
  const std::string kind = port_kind_of(model);
  Place place;
  place.port = word_of(entry, "port");
  if (kind == "i2c") {
    place.mux = word_of(entry, "mux");
    const auto channel = number_in(entry, "channel");
    if (!place.port.empty()) place.bus = fmt::format("'{}'", place.port);
    if (!place.mux.empty() && channel) place.bus = fmt::format("channel {} of '{}'", *channel, place.mux);
    place.address = address_of(entry, model);
  } else if (kind == "serial" && !place.port.empty()) {
    place.holds.push_back({fmt::format("the serial port '{}'", place.port), "port"});
  } else if (model.type == "bmi088") {
    hold(place, entry, "channel", "chip select");
    hold(place, entry, "gyro", "chip select");
  } else if (model.type == "dji_motor") {
    hold(place, entry, "feedback_id", "the identifier");
  } else if (model.type == "thruster") {
    hold_output(place, entry);
  }
  return place;
}

}  // namespace finemote::scenario
