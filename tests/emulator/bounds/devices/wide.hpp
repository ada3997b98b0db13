#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

/// As large as a value that crosses buckets may be: finemote::kCrossingBytes.
struct WideState : finemote::Stamp {
  std::uint8_t bytes[112]{};
};
struct WideCommand : finemote::Stamp {
  std::uint8_t bytes[112]{};
};
static_assert(sizeof(WideState) == 128 && sizeof(WideCommand) == 128);

struct WideValue {
  using State = WideState;
  using Command = WideCommand;
};

class Wide {
 public:
  void update() {
    state.origin = finemote::now();
    state.valid = true;
    ++state.bytes[3];
  }
  void handle() { state.bytes[5] = command.bytes[7]; }

  WideState state;
  WideCommand command;
};

class WideJoiner {
 public:
  constexpr explicit WideJoiner(finemote::Ports<WideValue> values) : values_(values) {}

  void update() {
    state = {finemote::now(), true};
    for (const auto& value : values_) {
      if (value.state.valid && value.state.origin < state.origin) state.origin = value.state.origin;
    }
  }
  void handle() {
    for (const auto& value : values_) {
      ++value.command.bytes[7];
      value.command.origin = state.origin;
      value.command.valid = true;
    }
  }

  finemote::Stamp state, command;

 private:
  finemote::Ports<WideValue> values_;
};

}  // namespace my
