// What the flags remember: a comparison that a later branch decides by.
#pragma once

#include <capstone/capstone.h>

#include <optional>
#include <utility>

#include "generator/wcet/interval.hpp"

namespace finemote::gen::wcet {

/// The flags are those of `left - right`.
struct Comparison {
  int left = ARM_REG_INVALID;   ///< register that still holds the left side, or none
  int right = ARM_REG_INVALID;  ///< the same of the right side
  Interval left_range, right_range;
  int result = ARM_REG_INVALID;  ///< register that still holds the difference, or none
  std::uint32_t base = 0;        ///< of both sides, whose ranges are distances from it: Value
  /// A side as a constant distance from a base; base 0: it is not.
  struct Offset {
    std::uint32_t base = 0, distance = 0;
    friend bool operator==(Offset a, Offset b) { return a.base == b.base && a.distance == b.distance; }
  };
  Offset left_offset, right_offset;
  bool only_result = false;  ///< carry and overflow are not those of a comparison: only EQ, NE, MI and PL count

  friend bool operator==(const Comparison& a, const Comparison& b) {
    return a.left == b.left && a.right == b.right && a.left_range == b.left_range && a.right_range == b.right_range &&
           a.result == b.result && a.base == b.base && a.left_offset == b.left_offset &&
           a.right_offset == b.right_offset && a.only_result == b.only_result;
  }
};

/// The ranges of left and right where `condition` holds; none: it never does.
std::optional<std::pair<Interval, Interval>> where(const Comparison& comparison, arm_cc condition);

/// The same of `left - right`.
std::optional<Interval> difference_where(const Comparison& comparison, arm_cc condition);

/// EQ for NE and so on.
arm_cc opposite(arm_cc condition);

}  // namespace finemote::gen::wcet
