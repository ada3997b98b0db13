// Pins that interrupt: which exceptions their routines are, and what devices declare of them.
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// Of all pins that devices of the robot let interrupt: EXTI, vector table of the STM32F407 (RM0090 12.2, table 62).
std::set<std::uint32_t> pin_exceptions(const Robot& robot);

/// What the types of devices say of the routines of their pins, or what is assumed where they do not.
struct PinWork {
  Position at;               ///< of the first of them
  Duration wcet;             ///< of one run for each of all
  bool is_computed = false;  ///< the image bounds it
  std::int64_t runs = 0;     ///< in the window, at most
};

/// None: no device lets a pin interrupt. May throw Overflow.
/// @param window  for so long edges are counted
std::optional<PinWork> declared_pin_work(const Robot& robot, const timing::Model& model, Duration window);

/// Reports FM6015 where pins interrupted more often than that: bounds are made from less.
/// @return  whether they did not
bool check_pin_edges(const Robot& robot, const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics);

}  // namespace finemote::gen
