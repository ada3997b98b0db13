// Entries of a scenario to what is wrong with their members, each by its row.
#pragma once

#include <string>
#include <vector>

#include "emulator/scenario/names.hpp"
#include "emulator/scenario/values.hpp"

namespace finemote::scenario {

class EntryCheck {
 public:
  using Value = gen::json::Value;
  EntryCheck(Names& names, gen::Diagnostics& diagnostics)
      : names_(names), diagnostics_(diagnostics), values_(diagnostics) {}

  /// Every member is in the rows and as they say, and none is missing. `whose`: the entry, in words.
  void object(const Value& entry, const std::vector<Member>& rows, const std::string& whose);
  /// None of the required members is missing.
  void complete(const Value& entry, const std::vector<Member>& rows, const std::string& whose);
  /// Exactly one of the names is there; none are asked for: nothing.
  void exactly_one(const Value& entry, const std::vector<std::string>& names, const std::string& whose);
  /// @return false: a single value that is not as its row says
  bool value(const Member& row, const std::string& name, const Value& value);
  /// Reports FM6004 unless the value is of the kind.
  bool is_kind(const std::string& name, const Value& value, Value::Kind kind) {
    return values_.is_kind(name, value, kind);
  }

 private:
  Names& names_;
  gen::Diagnostics& diagnostics_;
  ValueCheck values_;
};

/// The names rows stand for, families with all theirs.
std::vector<std::string> names_of(const std::vector<Member>& rows);
/// An item of a list: `events[2]`.
std::string item_name(const std::string& list, std::size_t number);

}  // namespace finemote::scenario
