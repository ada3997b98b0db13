#include "finemote/devices/key.hpp"

namespace finemote {

void Key::update() {
  const Time at = now();
  const bool level = pin_.active();
  if (level != level_ || !seen_) level_since_ = at;
  level_ = level;
  seen_ = true;
  if (at - level_since_ >= config_.debounce && (level != state.pressed || !state.valid)) {
    state.valid = true;
    state.pressed = level;
    state_since_ = level_since_;
    if (level) ++state.presses;
  }
  state.origin = at;
  state.held = state.valid ? at - state_since_ : 0;
}

}  // namespace finemote
