// Reads the firmware's trace ring while it runs, as a debug probe does: without costing the processor anything.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "emulator/chip/peripheral.hpp"
#include "emulator/core/image.hpp"

namespace finemote::emulator {

/// Start or end of a stage: the runtime's trace event with its time unwrapped.
struct StageEvent {
  std::int64_t t_ns;    ///< since the first release
  std::uint32_t stage;  ///< 2 * device in schedule order + (0 update, 1 handle)
  bool begin;
};

class TraceReader {
 public:
  /// @param image  has the symbol `_SEGGER_RTT` when the trace was built in
  TraceReader(World& world, const Image& image);

  [[nodiscard]] bool present() const { return control_.has_value(); }
  /// The firmware starts again: its clock does too, the events' goes on.
  void restarted();
  /// Takes what is in the ring now; called regularly by itself, and once more before looking at the result.
  void drain();
  [[nodiscard]] const std::vector<StageEvent>& events() const { return events_; }
  /// Events the firmware had no room for.
  [[nodiscard]] std::uint32_t lost() const;

 private:
  void poll();
  [[nodiscard]] std::int64_t clock_began() const;
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const;

  World& world_;
  std::optional<std::uint32_t> control_;
  std::vector<StageEvent> events_;
  std::int64_t cycles_ = 0;           ///< of the last event, unwrapped, since the firmware's clock began
  bool begins_ = true;                ///< no event yet since the start or restart
  std::optional<std::int64_t> zero_;  ///< when the first start's clock began, in cycles since power-on
  std::int64_t offset_ = 0;           ///< by which the present start's clock began later
};

}  // namespace finemote::emulator
