// Reads a level, works on it in two jobs, and publishes it with the third, which begins anew.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/i2c.hpp"
#include "finemote/interfaces/any.hpp"

namespace bounds {

struct LevelState : finemote::Stamp {
  std::uint16_t level = 0;
};

class Survey {
 public:
  constexpr explicit Survey(finemote::I2cSlot& slot) : slot_(&slot) {}

  void update() {
    if (step_ == 1 && !slot_->done())
      step_ = slot_->busy() ? 1 : 0;
    else if (step_ == 3)
      publish();
    else if (step_ != 0)
      ++step_;
    if (step_ == 0) ask();
  }
  void handle() {}

  LevelState state;

 private:
  static constexpr std::uint8_t kRegister[] = {0};

  void ask() {
    asked_ = finemote::now();
    slot_->start(kRegister, sizeof kRegister, answer_, sizeof answer_);
    step_ = 1;
  }
  void publish() {
    state.level = static_cast<std::uint16_t>(answer_[0] << 8 | answer_[1]);
    state.origin = asked_;
    state.valid = true;
    step_ = 0;
  }

  finemote::I2cSlot* slot_;
  finemote::Time asked_ = 0;
  int step_ = 0;
  std::uint8_t answer_[2]{};
};

}  // namespace bounds
