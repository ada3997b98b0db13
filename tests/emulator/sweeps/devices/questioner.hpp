// Asks the longest question of an RS-485 line for the longest answer, and leaves it to others to carry the line on.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/rs485.hpp>

namespace testing {

class Questioner {
 public:
  constexpr explicit Questioner(finemote::Rs485Slot& slot) : slot_(&slot) {}

  void update() { slot_->start(question_, sizeof question_, finemote::Rs485Slot::kMaxReply); }
  void handle() {}

  finemote::Stamp state;

 private:
  finemote::Rs485Slot* const slot_;
  std::uint8_t question_[128]{};
};

}  // namespace testing
