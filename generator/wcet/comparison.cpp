#include "generator/wcet/comparison.hpp"

#include <utility>

namespace finemote::gen::wcet {
namespace {

using Ranges = std::pair<Interval, Interval>;

constexpr std::uint32_t kSign = 0x80000000U;

std::optional<Ranges> both(std::optional<Interval> left, std::optional<Interval> right) {
  if (!left || !right) return std::nullopt;
  return Ranges{*left, *right};
}

/// Without `value` where it is at an end.
std::optional<Interval> without(Interval range, std::uint32_t value) {
  if (range.is_constant()) return range.low == value ? std::nullopt : std::optional(range);
  if (range.low == value) ++range.low;
  if (range.high == value) --range.high;
  return range;
}

std::optional<Ranges> equal(Interval left, Interval right) {
  const auto same = meet(left, right);
  return both(same, same);
}

std::optional<Ranges> different(Interval left, Interval right) {
  return both(right.is_constant() ? without(left, right.low) : left,
              left.is_constant() ? without(right, left.low) : right);
}

std::optional<Ranges> less(Interval left, Interval right) {
  if (right.high == 0 || left.low == UINT32_MAX) return std::nullopt;
  return both(meet(left, {0, right.high - 1}), meet(right, {left.low + 1, UINT32_MAX}));
}

std::optional<Ranges> less_or_equal(Interval left, Interval right) {
  return both(meet(left, {0, right.high}), meet(right, {left.low, UINT32_MAX}));
}

std::optional<Ranges> swapped(std::optional<Ranges> ranges) {
  if (ranges) std::swap(ranges->first, ranges->second);
  return ranges;
}

/// Signed order is unsigned order with the sign bit turned round. A range that holds both signs becomes all there is.
std::optional<Interval> biased(Interval range) {
  if ((range.low & kSign) != (range.high & kSign)) return std::nullopt;
  return Interval{range.low ^ kSign, range.high ^ kSign};
}

Interval unbiased(Interval range, Interval otherwise) {
  const bool is_one_sign = (range.low & kSign) == (range.high & kSign);
  if (!is_one_sign) return otherwise;
  const Interval back{range.low ^ kSign, range.high ^ kSign};
  return meet(back, otherwise).value_or(otherwise);
}

template <class Relation>
std::optional<Ranges> signed_order(Interval left, Interval right, Relation relation) {
  const auto result = relation(biased(left).value_or(Interval::any()), biased(right).value_or(Interval::any()));
  if (!result) return std::nullopt;
  return Ranges{unbiased(result->first, left), unbiased(result->second, right)};
}

}  // namespace

std::optional<Ranges> where(const Comparison& c, arm_cc condition) {
  const Interval left = c.left_range, right = c.right_range;
  if (condition == ARM_CC_EQ) return equal(left, right);
  if (condition == ARM_CC_NE) return different(left, right);
  if (c.only_result) return Ranges{left, right};
  switch (condition) {
    case ARM_CC_LO:
      return less(left, right);
    case ARM_CC_LS:
      return less_or_equal(left, right);
    case ARM_CC_HI:
      return swapped(less(right, left));
    case ARM_CC_HS:
      return swapped(less_or_equal(right, left));
    case ARM_CC_LT:
      return signed_order(left, right, less);
    case ARM_CC_LE:
      return signed_order(left, right, less_or_equal);
    case ARM_CC_GT:
      return swapped(signed_order(right, left, less));
    case ARM_CC_GE:
      return swapped(signed_order(right, left, less_or_equal));
    default:
      return Ranges{left, right};
  }
}

std::optional<Interval> difference_where(const Comparison& c, arm_cc condition) {
  const Interval difference = subtract(c.left_range, c.right_range);
  switch (condition) {
    case ARM_CC_EQ:
      return meet(difference, Interval::of(0));
    case ARM_CC_NE:
      return without(difference, 0);
    case ARM_CC_PL:
      return meet(difference, {0, kSign - 1});
    case ARM_CC_MI:
      return meet(difference, {kSign, UINT32_MAX});
    default:
      return difference;
  }
}

/// Conditions come in pairs that differ in their lowest bit (ARMv7-M A7.3); capstone counts them from 1.
arm_cc opposite(arm_cc condition) { return static_cast<arm_cc>(((static_cast<unsigned>(condition) - 1U) ^ 1U) + 1U); }

}  // namespace finemote::gen::wcet
