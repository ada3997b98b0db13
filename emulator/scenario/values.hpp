// Values of a scenario's members to what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "emulator/scenario/grammar.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::scenario {

/// The number a value is written as; infinite where it is beyond what can be stored.
double number_of(const gen::json::Value& value);
/// As written, shortened where it is very long.
std::string shown(const gen::json::Value& value);
/// `'a', 'b' and 'c'`; `last` is the word before the last one.
std::string quoted(const std::vector<std::string>& names, const char* last);
/// `PA0` to `PI11`: no package of the chip has more of port I.
bool is_pin(const std::string& pin);

/// Judges single values by their rows. Names of parts and ports are judged by the caller.
class ValueCheck {
 public:
  using Value = gen::json::Value;
  explicit ValueCheck(gen::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Of every kind but part, reference, port, object and list. @return false after a report
  bool simple(const Member& row, const std::string& name, const Value& value);
  /// Reports FM6004 unless the value is of the kind.
  bool is_kind(const std::string& name, const Value& value, Value::Kind kind);

 private:
  bool number(const Member& row, const std::string& name, const Value& value);
  bool numbers(const Member& row, const std::string& name, const Value& value, std::size_t count);
  bool word(const Member& row, const std::string& name, const Value& value);
  bool out_of_range(const std::string& name, const Value& value, const std::string& wanted);

  gen::Diagnostics& diagnostics_;
};

}  // namespace finemote::scenario
