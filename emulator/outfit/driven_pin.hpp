// A pin that is a plain output, or a timer's, to how what hangs at it is driven.
#pragma once

#include <functional>
#include <vector>

#include "emulator/chip/gpio.hpp"
#include "emulator/chip/timer.hpp"

namespace finemote::emulator {

struct Drive {
  double share = 0;  ///< of the time the pin is high, 0..1
  double hertz = 0;  ///< how often it becomes so; 0: it stays as it is
  bool operator==(const Drive&) const = default;
};

/// Of a pulse output that has its pin.
Drive drive_of(Timer::Pulse pulse);

/// Whoever has the pin drives it: the output register, or the timer; nobody where it is an input.
class DrivenPin {
 public:
  using Listener = std::function<void(Drive drive)>;

  /// Becomes the watcher of the pin.
  DrivenPin(Gpio& gpio, unsigned pin);
  DrivenPin(const DrivenPin&) = delete;
  DrivenPin& operator=(const DrivenPin&) = delete;

  /// What the timer makes of its channel from now on.
  void set_pulse(Timer::Pulse pulse);
  /// Is told now and whenever it changes.
  void listen(Listener listener);

 private:
  [[nodiscard]] Drive now() const;
  void tell();

  Gpio& gpio_;
  unsigned pin_;
  Timer::Pulse pulse_{};
  Drive last_;
  std::vector<Listener> listeners_;
};

}  // namespace finemote::emulator
