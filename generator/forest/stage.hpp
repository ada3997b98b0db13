// The number of a stage, as generated code, the marks of an image and the records of runs count them.
#pragma once

#include <cstdint>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// update() or handle() of the device at a place of the order.
struct Stage {
  Rank rank;
  bool is_handle = false;

  static constexpr Stage of_number(std::size_t number) { return {Rank{number / 2}, number % 2 == 1}; }
  [[nodiscard]] constexpr std::uint32_t number() const {
    return static_cast<std::uint32_t>(2 * rank.value() + (is_handle ? 1 : 0));
  }
};

/// What code and documents call it.
constexpr const char* stage_name(bool is_handle) { return is_handle ? "handle" : "update"; }

}  // namespace finemote::gen
