// BMI088 inertial sensor: an accelerometer and a gyroscope behind two chip selects (data sheet BST-BMI088-DS001).
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "emulator/chip/spi.hpp"
#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

/// Samples are held between conversions, as the parts do: the accelerometer at the rate of ACC_CONF, the gyroscope at
/// that of GYRO_BANDWIDTH; what counts as the age of a value is its conversion. Their filters are not modelled.
class Bmi088 {
 public:
  /// @param now     the board's time
  /// @param motion  what acts on the part at a time
  Bmi088(std::function<Time()> now, std::function<Motion(Time)> motion)
      : now_(std::move(now)), motion_(std::move(motion)) {
    reset_accelerometer();
    reset_gyroscope();
  }

  SpiPart accelerometer();
  SpiPart gyroscope();

  bool silent = false;      ///< answers nothing: the line stays high
  double temperature = 25;  ///< degrees Celsius
  /// Told at the end of a read of rates; `from`: when the older of acceleration and rates was taken.
  std::function<void(Time from)> on_read;
  void power_cycle();

 private:
  struct Exchange {
    bool selected = false, reading = false;
    unsigned count = 0;
    std::uint8_t address = 0;
  };
  std::uint8_t accelerometer_byte(std::uint8_t out);
  std::uint8_t gyroscope_byte(std::uint8_t out);
  void accelerometer_selected(bool selected);
  void gyroscope_selected(bool selected);
  void write_accelerometer(std::uint8_t address, std::uint8_t value);
  void write_gyroscope(std::uint8_t address, std::uint8_t value);
  void reset_accelerometer();
  void reset_gyroscope();
  void sample_acceleration();
  void sample_rates();

  std::function<Time()> now_;
  std::function<Motion(Time)> motion_;
  std::array<std::uint8_t, 128> accel_{}, gyro_{};
  Exchange accel_exchange_, gyro_exchange_;
  bool accel_on_spi_ = false;
  Time accel_ready_ = 0, gyro_ready_ = 0;  ///< not before: resets take their time
  Time accel_sampled_ = 0, gyro_sampled_ = 0;
};

}  // namespace finemote::emulator
