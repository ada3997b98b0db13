// Turns the registers of a BMI088 accelerometer and gyroscope into rates, acceleration and attitude.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/control/attitude.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/spi.hpp"

namespace finemote {

/// Two chips in one part, each with its own chip select: the device's bus is the accelerometer's, `use` role `gyro` the
/// gyroscope's. Ranges +-6 g and +-2000 deg/s.
///
/// Nothing waits: every update() takes the two reads of the one before and starts the next two; the state's origin is
/// when the earlier of them ended. Bring-up (resets, settings, identities) is a state with `valid = false`. The
/// gyroscope's identity and the accelerometer's own clock are read along: a part that stands still, is missing or was
/// reset is invalid at once and brought up again after kMaxFailures reads.
class Bmi088 {
 public:
  struct Config {
    float kp = 0.5F;   ///< 1/s, see AttitudeFilter
    float ki = 0.01F;  ///< 1/s^2
  };
  static constexpr std::uint8_t kMaxFailures = 3;

  constexpr Bmi088(const Config& config, SpiSlot& accelerometer, SpiSlot& gyroscope)
      : gains_{config.kp, config.ki}, accel_(&accelerometer), gyro_(&gyroscope) {}

  void update();
  void handle() {}

  ImuState state;

 private:
  enum class Step : std::uint8_t { kWait, kSetUp, kCheck, kRun };

  void set_up();
  void check();
  void take_sample();
  void start_reads();
  void fail();
  void begin_again();

  AttitudeFilter::Gains gains_;
  SpiSlot* accel_;
  SpiSlot* gyro_;
  Step step_ = Step::kWait;
  std::uint8_t entry_ = 0;     ///< of the set-up table
  std::uint8_t failures_ = 0;  ///< in a row
  bool started_ = false;
  Time wait_until_ = 0;
  Time sampled_ = 0;
  std::uint32_t chip_time_ = 0;
  AttitudeFilter attitude_;
  std::uint8_t accel_out_[11]{}, accel_in_[11]{};
  std::uint8_t gyro_out_[9]{}, gyro_in_[9]{};
};

}  // namespace finemote
