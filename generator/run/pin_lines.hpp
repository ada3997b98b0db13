// Pins that interrupt: what devices declare of them, and how often they did.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"
#include "generator/run/traffic.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// One routine, which may serve the pins of several devices.
struct PinLine {
  std::uint32_t exception = 0;  ///< EXTI in the vector table of the STM32F407 (RM0090 12.2, table 62)
  Position at;                  ///< the first device with a pin there
  std::string devices = {};     ///< `'counter', 'key'`
  Duration wcet = {};           ///< of one run for each of them
  bool is_assumed = true;       ///< by all of their types or by us: the image does not bound it
  std::int64_t runs = 0;        ///< in the window, at most
};

/// Of all devices that let pins interrupt; empty, too, where the numbers are too large.
/// @param window  how long edges are counted
std::vector<PinLine> pin_lines(const Robot& robot, const timing::Model& model, Duration window);

struct MeasuredPins {
  PinLine line;
  Duration window;
  Declared<std::int64_t> runs;

  [[nodiscard]] Judgement judged() const { return runs.judged(); }
};

/// Of one run on the emulated board.
std::vector<MeasuredPins> measure_pins(const Robot& robot, const timing::Model& model, const RunRecord& record);

/// Reports FM6015 for every line that interrupted more often than is declared: bounds are made from less.
/// @return  whether there is none
bool check_pin_edges(const std::vector<MeasuredPins>& pins, Diagnostics& diagnostics);

}  // namespace finemote::gen
