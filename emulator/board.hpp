// A board with an STM32F407 in software: load an image, attach parts, run, and look at what happened.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "emulator/chip/chip.hpp"
#include "emulator/core/image.hpp"
#include "emulator/core/loop_counts.hpp"
#include "emulator/core/own_times.hpp"
#include "emulator/trace_reader.hpp"

namespace finemote::emulator {

struct BoardOptions {
  CostModel cost = CostModel::cortex_m4;
  FlashModel flash = FlashModel::hit;
  std::uint32_t lsi_hz = 32'000;
  bool keeps_log = false;  ///< keeps every event of the execution log
  bool probe = true;       ///< reads the trace ring; false leaves it to the firmware
  Silicon silicon;         ///< which freedom of its manual the chip uses
  bool tags = false;       ///< follows where bytes come from: `World::provenance` knows of the firmware then
};

/// One emulated board. Two runs of the same image with the same parts and events are equal in every event.
class Board {
 public:
  /// @param wiring  what the board connects to the chip; the default: nothing, the bare chip at 12 MHz
  explicit Board(Wiring wiring = {}, const BoardOptions& options = {});

  /// Puts the image into flash and resets. @throws std::runtime_error when it does not fit the board
  void load(const Image& image);
  /// Runs on for this long, or until the image ends itself, locks up, or sleeps for ever.
  Stop run_for(std::uint64_t ns);

  /// Pulls the reset pin: everything starts again, whatever was under way. Parts stay as they are.
  void press_reset();

  [[nodiscard]] std::uint64_t now_ns() const { return to_ns(cpu_->now()); }
  Chip& chip() { return chip_; }
  Cpu& cpu() { return *cpu_; }
  World& world() { return world_; }
  [[nodiscard]] const std::vector<Report>& reports() const { return world_.reports().all(); }
  [[nodiscard]] unsigned resets() const { return resets_; }

  /// Stages as the firmware traced them; empty without the trace option.
  [[nodiscard]] const std::vector<StageEvent>& stages();
  [[nodiscard]] std::uint32_t lost_stage_events() const { return trace_ ? trace_->lost() : 0; }

  /// Since power-on.
  [[nodiscard]] const OwnTimes& own_times();
  /// Counts how often the places of these loops are passed, which the image has; before power-on.
  void watch_loops(const std::vector<WatchedLoop>& loops);
  [[nodiscard]] const LoopCounts& loop_counts();

  /// The execution log since power-on; empty without `BoardOptions::keeps_log`.
  [[nodiscard]] const ExecutionLog& log();

  /// Statistics of the bus at a port (`usart6`, `i2c2`); all zero for one that is not a bus.
  [[nodiscard]] BusStatistics bus(const std::string& port);

  /// A word of RAM by symbol name. @throws std::runtime_error when the image has no such symbol
  [[nodiscard]] std::uint32_t word(const std::string& symbol, std::uint32_t offset = 0);
  void set_word(const std::string& symbol, std::uint32_t value, std::uint32_t offset = 0);

 private:
  void restart(std::uint32_t cause);
  void fill_ram();
  void look_at_log();

  World world_;
  Chip chip_;
  BoardOptions options_;
  std::unique_ptr<Cpu> cpu_;
  Image image_;
  std::unique_ptr<TraceReader> trace_;
  ExecutionLog log_;   ///< what has not been looked at
  ExecutionLog kept_;  ///< what has, where that is kept
  OwnTimes own_times_;
  LoopCounts loop_counts_;
  unsigned resets_ = 0;
};

}  // namespace finemote::emulator
