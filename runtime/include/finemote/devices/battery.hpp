// Turns an analog input into the voltage of a battery, and says when it is low.
#pragma once

#include <cstdint>

#include "finemote/analog.hpp"
#include "finemote/contract.hpp"
#include "finemote/interfaces/battery.hpp"

namespace finemote {

/// The supply behind an analog input. Every update() takes the measurement the one before began. The state's origin is
/// when that one began; it is valid while measurements come and lie between kLeast and the end of the scale.
/// `low` and `empty` say what the smoothed voltage has been below for `hold`, and go again when it has been above by
/// `kReturn` as long: a motor that starts does not empty the battery.
class BatterySense {
 public:
  static constexpr float kLeast = 3;                       ///< V: below, nothing is connected
  static constexpr float kReturn = 0.3F;                   ///< V
  static constexpr Duration kMaxAge = 500 * kMillisecond;  ///< of a measurement

  struct Config {
    float low = 22;                        ///< V
    float empty = 20;                      ///< V
    Duration smooth = 100 * kMillisecond;  ///< time constant of the voltage shown
    Duration hold = 1 * kSecond;
  };

  constexpr BatterySense(const Config& config, AnalogPin input) : config_(config), input_(input) {}

  void update();
  void handle() {}

  BatteryState state;

 private:
  /// A voltage that counts as below when it has been for so long.
  struct Limit {
    bool below = false;
    Time changed = 0;  ///< since when the voltage has spoken for the other answer; 0: it does not
    bool judge(float voltage, float limit, Time at, Duration hold);
  };
  void take(float voltage, Time at);

  const Config config_;
  AnalogPin input_;
  Time begun_ = 0, taken_ = 0;
  bool running_ = false;
  Limit low_, empty_;
};

}  // namespace finemote
