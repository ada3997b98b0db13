// A remote control in an operator's hands.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace finemote {

/// Where a switch of two or three positions stands.
enum class RemoteSwitch : std::uint8_t {
  kUnknown,  ///< nothing received yet, or no such switch
  kUp,
  kMiddle,
  kDown,
};

/// What the operator does.
struct RemoteState : Stamp {
  float right_x = 0;                                   ///< right stick, -1..1, to the right
  float right_y = 0;                                   ///< away from the operator
  float left_x = 0;                                    ///< left stick, likewise
  float left_y = 0;                                    ///< away from the operator
  float wheel = 0;                                     ///< -1..1
  RemoteSwitch left_switch = RemoteSwitch::kUnknown;   ///< beside the left stick
  RemoteSwitch right_switch = RemoteSwitch::kUnknown;  ///< beside the right stick
  std::int16_t mouse[3] = {};  ///< movement x, y and wheel, in counts per frame; 0 where there is none
  bool mouse_left = false;     ///< its button is pressed
  bool mouse_right = false;    ///< its button is pressed
  std::uint16_t keys = 0;      ///< bit n: key n of W S A D shift ctrl Q E R F G Z X C V B; 0 where there are none
};

/// Offered by receivers of remote controls; nothing to command.
struct Remote {
  using State = RemoteState;
  using Command = void;
};

}  // namespace finemote
