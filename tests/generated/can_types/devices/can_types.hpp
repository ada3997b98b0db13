// Three parts on CAN, each with another form of identifiers.
#pragma once

#include <cstdint>

#include "finemote/can.hpp"
#include "finemote/contract.hpp"

namespace my {

struct HeardState : finemote::Stamp {
  std::uint16_t identifier = 0;  ///< of the last frame
};
struct Heard {
  using State = HeardState;
  using Command = void;
};

class WideServo {
 public:
  constexpr explicit WideServo(finemote::CanSlot& slot) : slot_(&slot) {}

  void update() {
    const auto position = slot_->received(), temperature = slot_->received(1);
    state.identifier = temperature.count > 0 ? temperature.frame.id : position.frame.id;
  }
  /// Its id four times over: to be found on the wire.
  void handle() {
    const auto id = static_cast<std::uint8_t>(slot_->id());
    const std::uint8_t bytes[]{id, id, id, static_cast<std::uint8_t>(0xF0U | id)};
    slot_->set_shared(bytes);
  }

  HeardState state;

 private:
  finemote::CanSlot* slot_;
};

class BlockDrive {
 public:
  constexpr explicit BlockDrive(finemote::CanSlot& slot) : slot_(&slot) {}

  void update() { state.identifier = slot_->received().frame.id; }
  void handle() {}

  HeardState state;

 private:
  finemote::CanSlot* slot_;
};

class Meter {
 public:
  constexpr explicit Meter(finemote::CanSlot& slot) : slot_(&slot) {}

  void update() { state.identifier = slot_->received().frame.id; }
  void handle() {}

  HeardState state;

 private:
  finemote::CanSlot* slot_;
};

}  // namespace my
