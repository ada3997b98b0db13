// A gauge with a valve, on I2C: a sensor that takes commands, which FineMote does not ship.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/i2c.hpp"

namespace campaign {

struct LevelState : finemote::Stamp {
  std::uint16_t level = 0;  ///< as the part gives it
};

struct LevelCommand : finemote::Stamp {
  std::uint8_t opening = 0;  ///< of the valve; 0: shut
};

struct Level {
  using State = LevelState;
  using Command = LevelCommand;
};

/// handle() reads the level and sets the valve in one unit on the bus; the update() that follows takes the level.
class Gauge {
 public:
  struct Config {
    finemote::Duration max_age = 200 * finemote::kMillisecond;  ///< of the command's origin, and of a level
  };

  constexpr Gauge(const Config& config, finemote::I2cSlot& slot) : config_(config), slot_(&slot) {}

  void update() {
    if (is_asked_ && slot_->done()) take();
    if (!finemote::is_fresh(state, finemote::now(), config_.max_age)) state.valid = false;
  }

  void handle() {
    if (slot_->busy()) return;
    valve_[1] = finemote::is_fresh(command, finemote::now(), config_.max_age) ? command.opening : std::uint8_t{0};
    asked_ = finemote::now();
    is_asked_ = slot_->start(kLevel, sizeof kLevel, level_, sizeof level_, valve_, sizeof valve_);
  }

  /// Shuts the valve before anything else is sent. May interrupt update() and handle().
  void safe() { slot_->set_safe(kShut, sizeof kShut); }

  LevelState state;
  LevelCommand command;

 private:
  static constexpr std::uint8_t kLevelRegister = 0x00, kValveRegister = 0x10;
  static constexpr std::uint8_t kLevel[] = {kLevelRegister}, kShut[] = {kValveRegister, 0};

  void take() {
    is_asked_ = false;
    state.level = static_cast<std::uint16_t>(level_[0] << 8 | level_[1]);
    state.origin = asked_;
    state.valid = true;
  }

  Config config_;
  finemote::I2cSlot* slot_;
  bool is_asked_ = false;
  finemote::Time asked_ = 0;
  std::uint8_t level_[2]{}, valve_[2]{kValveRegister, 0};
};

}  // namespace campaign
