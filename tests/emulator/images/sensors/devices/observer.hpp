// Writes down what the sensors of the board say, for the test to read.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/interfaces/imu.hpp>
#include <finemote/interfaces/magnetometer.hpp>

namespace testing {

/// Of one sensor: whether it is valid, how often that has changed, and its origin [ns].
struct Seen {
  std::uint32_t valid, changes, origin_low, origin_high;
};

}  // namespace testing

/// Read by the test: the inertial sensor, the compass; then the field along x [nT].
extern "C" {
inline testing::Seen sensors_seen[2]{};
inline std::int32_t field_seen = 0;
}

namespace testing {

class Observer {
 public:
  constexpr Observer(finemote::Port<finemote::Imu> imu, finemote::Port<finemote::Magnetometer> compass)
      : imu_(imu), compass_(compass) {}

  void update() {
    note(sensors_seen[0], imu_.state);
    note(sensors_seen[1], compass_.state);
    field_seen = static_cast<std::int32_t>(compass_.state.field[0] * 1e9F);
    state = imu_.state;
  }
  void handle() {}

  finemote::Stamp state;

 private:
  static void note(Seen& seen, const finemote::Stamp& stamp) {
    const std::uint32_t valid = stamp.valid ? 1 : 0;
    if (seen.valid != valid) ++seen.changes;
    seen.valid = valid;
    seen.origin_low = static_cast<std::uint32_t>(stamp.origin);
    seen.origin_high = static_cast<std::uint32_t>(stamp.origin >> 32);
  }

  finemote::Port<finemote::Imu> imu_;
  finemote::Port<finemote::Magnetometer> compass_;
};

}  // namespace testing
