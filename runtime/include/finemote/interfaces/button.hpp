// A button somebody presses.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace finemote {

/// What it says.
struct ButtonState : Stamp {
  bool pressed = false;       ///< now, contact bounce left out
  std::uint32_t presses = 0;  ///< times it was pressed since start
  Duration held = 0;          ///< how long it has been as it is
};

/// Offered by keys; nothing to command.
struct Button {
  using State = ButtonState;
  using Command = void;
};

}  // namespace finemote
