// Asks four bytes on an RS-485 line every update, and keeps the three of the answer; without one it is not valid.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/rs485.hpp>

namespace testing {

/// Of one unit: answers, the last one's bytes, questions without one, and whether the state is valid.
struct Answers {
  std::uint32_t count, last, missing, valid;
};

}  // namespace testing

/// Read by the test: of the units with an odd and with an even number.
extern "C" {
inline testing::Answers answers_seen[2]{};
}

namespace testing {

class Asker {
 public:
  constexpr explicit Asker(finemote::Rs485Slot& slot) : slot_(&slot) {}

  void update() {
    if (slot_->busy()) return;
    Answers& seen = answers_seen[1 - slot_->id() % 2];
    state.valid = slot_->state() == finemote::SlotState::kDone;
    if (state.valid) {
      ++seen.count;
      const std::uint8_t* reply = slot_->reply();
      seen.last = static_cast<std::uint32_t>(reply[0]) << 16 | static_cast<std::uint32_t>(reply[1]) << 8 | reply[2];
      state.origin = finemote::now();
    } else if (slot_->state() != finemote::SlotState::kIdle) {
      ++seen.missing;
    }
    seen.valid = state.valid ? 1 : 0;
    question_[1] = slot_->id();
    slot_->start(question_, sizeof question_, 3);
  }
  void handle() {}

  finemote::Stamp state;

 private:
  finemote::Rs485Slot* const slot_;
  std::uint8_t question_[4] = {0x3E, 0, 0x55, 0x01};
};

}  // namespace testing
