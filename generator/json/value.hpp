// The JSON tree readers of model files work on: plain values that know where they were written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen::json {

struct Member;

struct Value {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool truth = false;           ///< of a boolean
  std::string text;             ///< a string, decoded to UTF-8; a number as written
  std::vector<Value> items;     ///< of an array
  std::vector<Member> members;  ///< of an object, in file order; repeated keys stay out (they were reported)
  Position at;                  ///< first byte
  std::size_t length = 1;       ///< bytes a caret underlines; 1 for arrays and objects

  [[nodiscard]] bool is(Kind k) const { return kind == k; }
  [[nodiscard]] const Value* find(std::string_view key) const;
};

struct Member {
  std::string key;
  Position at;  ///< opening quote of the key
  Value value;
};

inline const Value* Value::find(std::string_view key) const {
  for (const Member& m : members) {
    if (m.key == key) return &m.value;
  }
  return nullptr;
}

/// `a string`, `an object`: for messages.
std::string_view describe(Value::Kind kind);

}  // namespace finemote::gen::json
