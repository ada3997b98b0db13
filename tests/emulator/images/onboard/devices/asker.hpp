// Asks four bytes on an RS-485 line every update, and keeps the three of the answer.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/rs485.hpp>

/// Read by the test: answers, and the last one's bytes.
extern "C" {
inline std::uint32_t answers_seen[2]{};
}

namespace testing {

class Asker {
 public:
  constexpr explicit Asker(finemote::Rs485Slot& slot) : slot_(&slot) {}

  void update() {
    if (slot_->busy()) return;
    if (slot_->state() == finemote::SlotState::kDone) {
      ++answers_seen[0];
      const std::uint8_t* reply = slot_->reply();
      answers_seen[1] =
          static_cast<std::uint32_t>(reply[0]) << 16 | static_cast<std::uint32_t>(reply[1]) << 8 | reply[2];
      state.valid = true;
      state.origin = finemote::now();
    }
    question_[1] = slot_->id();
    slot_->start(question_, sizeof question_, 3);
  }
  void handle() {}

  finemote::Stamp state;

 private:
  finemote::Rs485Slot* slot_;
  std::uint8_t question_[4] = {0x3E, 0, 0x55, 0x01};
};

}  // namespace testing
