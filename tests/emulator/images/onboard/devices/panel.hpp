// Shows what the board sees: green while the key is down, with a tone; blue else, red when the battery is low; nothing
// without a valid battery.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/interfaces/battery.hpp>
#include <finemote/interfaces/button.hpp>
#include <finemote/interfaces/light.hpp>
#include <finemote/interfaces/sounder.hpp>

namespace testing {

class Panel {
 public:
  constexpr Panel(finemote::Port<finemote::Button> key, finemote::Port<finemote::Battery> supply,
                  finemote::Ports<finemote::Light> lamps, finemote::Port<finemote::Sounder> horn)
      : key_(key), supply_(supply), lamps_(lamps), horn_(horn) {}

  void update() {
    state.origin = finemote::oldest(key_.state.origin, supply_.state.origin);
    state.valid = key_.state.valid && supply_.state.valid;
  }
  void handle() {
    const bool down = key_.state.pressed;
    for (const auto& lamp : lamps_) {
      static_cast<finemote::Stamp&>(lamp.command) = state;
      lamp.command.red = supply_.state.low ? 0.75F : 0;
      lamp.command.green = down ? 0.5F : 0;
      lamp.command.blue = down ? 0 : 0.25F;
    }
    static_cast<finemote::Stamp&>(horn_.command) = state;
    horn_.command.frequency = down ? 2000 : 0;
  }

  finemote::Stamp state;

 private:
  finemote::Port<finemote::Button> key_;
  finemote::Port<finemote::Battery> supply_;
  finemote::Ports<finemote::Light> lamps_;
  finemote::Port<finemote::Sounder> horn_;
};

}  // namespace testing
