#include "finemote/devices/led.hpp"

namespace finemote {

namespace {

/// 0..1; what is no number is 0.
float share_of(float value) { return value > 0 ? (value < 1 ? value : 1) : 0; }

float brighter(float a, float b) { return a > b ? a : b; }

}  // namespace

void Led::update() {
  state.origin = now();
  state.valid = !own_.unreachable();
  state.red = shown_[0];
  state.green = shown_[1];
  state.blue = shown_[2];
}

void Led::handle() {
  if (!is_fresh(command, now(), config_.max_age)) return lose();
  show(share_of(command.red), share_of(command.green), share_of(command.blue));
}

void Led::safe() {
  if (config_.on_loss == OnLoss::kBlink) return lose();
  show(0, 0, 0);
}

void Led::lose() {
  switch (config_.on_loss) {
    case OnLoss::kHold:
      return;
    case OnLoss::kOff:
      return show(0, 0, 0);
    case OnLoss::kBlink: {
      const Time at = now();
      if (at >= turn_at_) {
        lit_ = !lit_;
        turn_at_ = at + config_.blink / 2;
      }
      return show(lit_ ? 1.0F : 0.0F, 0, 0);
    }
  }
}

void Led::show(float red, float green, float blue) {
  shown_[0] = red;
  shown_[1] = green;
  shown_[2] = blue;
  const bool colours = green_ != nullptr || blue_ != nullptr;
  own_.set_share((colours ? red : brighter(red, brighter(green, blue))) * config_.brightness);
  if (green_ != nullptr) green_->set_share(green * config_.brightness);
  if (blue_ != nullptr) blue_->set_share(blue * config_.brightness);
}

}  // namespace finemote
