// What generated code assigns members of a Config with.
#pragma once

#include <type_traits>

namespace finemote {

namespace detail {

/// The same type; or two integers of one size and sign, as `int` and `long` are on some targets.
template <class Member, class Value>
inline constexpr bool is_exact = std::is_same_v<std::remove_cv_t<Member>, Value> ||
                                 (std::is_integral_v<Member> && std::is_integral_v<Value> &&
                                  !std::is_same_v<std::remove_cv_t<Member>, bool> && !std::is_same_v<Value, bool> &&
                                  sizeof(Member) == sizeof(Value) &&
                                  std::is_signed_v<Member> == std::is_signed_v<Value>);

}  // namespace detail

/// The value of a param for a member of a Config: `c.hold = exact<decltype(c.hold)>(20 * kMillisecond);`. Assignment
/// would convert: a float to an int, anything to bool. This does not.
template <class Member, class Value>
constexpr std::enable_if_t<detail::is_exact<Member, Value>, Value> exact(Value value) {
  return value;
}

/// The member of Config has another type than the param: docs/howto/add-a-device.md has the table of types.
template <class Member, class Value>
constexpr std::enable_if_t<!detail::is_exact<Member, Value>, Value> exact(Value value) = delete;

}  // namespace finemote
