// BMI088 inertial sensor: an accelerometer and a gyroscope behind two chip selects (data sheet BST-BMI088-DS001).
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "emulator/chip/spi.hpp"
#include "emulator/parts/ready_output.hpp"
#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

/// Samples are held between conversions, as the parts do: the accelerometer at the rate of ACC_CONF, the gyroscope at
/// that of GYRO_BANDWIDTH, the temperature every 1.28 s; what counts as the age of a value is its conversion. Their
/// filters are not modelled.
///
/// Each chip says at two outputs of its own that there is a new sample. The gyroscope's become inactive by themselves
/// after 280 us (the data sheet says 280 to 400); the accelerometer's too, as it does not say for how long they stay,
/// or when their status is read. An output that nothing is mapped to leaves its wire alone.
class Bmi088 {
 public:
  enum class Output : std::uint8_t { int1, int2, int3, int4 };  ///< the first two are the accelerometer's
  enum class Quantity : std::uint8_t { rates, acceleration };

  /// @param motion       what acts on the part at a time
  /// @param temperature  of the part at a time [degrees Celsius]; asked in the order of time
  Bmi088(PartClock clock, std::function<Motion(Time)> motion, std::function<double(Time)> temperature);
  Bmi088(const Bmi088&) = delete;
  Bmi088& operator=(const Bmi088&) = delete;

  SpiPart accelerometer();
  SpiPart gyroscope();

  bool silent = false;  ///< answers nothing: the line stays high; takes no samples
  /// Asked, when a read comes to the values of a quantity taken at `from`, what their bytes carry.
  std::function<Tag(Quantity quantity, Time from)> on_sample;
  /// Told at the end of such a read.
  std::function<void(Quantity quantity, Tag sample)> on_read;
  /// Told the level an output drives when that changes: 1, 0, or -1: none.
  std::function<void(Output output, int level)> on_output;
  void power_cycle();

 private:
  struct Exchange {
    bool selected = false, reading = false;
    unsigned count = 0;
    std::uint8_t address = 0;
    Tag sample = Tag::none;  ///< of the quantity it reads
  };
  WireByte accelerometer_byte(std::uint8_t out);
  WireByte gyroscope_byte(std::uint8_t out);
  WireByte value_byte(Exchange& exchange, Quantity quantity, unsigned address);
  void end(const Exchange& exchange, Quantity quantity);
  void accelerometer_selected(bool selected);
  void gyroscope_selected(bool selected);
  void write_accelerometer(std::uint8_t address, std::uint8_t value);
  void write_gyroscope(std::uint8_t address, std::uint8_t value);
  void test_gyroscope(std::uint8_t value);
  void reset_accelerometer();
  void reset_gyroscope();
  void sample_acceleration();
  void sample_rates();
  void convert_temperature(Time at, std::uint64_t token);
  void set_accelerometer_outputs();
  void set_gyroscope_outputs();
  [[nodiscard]] Time now() const { return clock_.now(); }
  [[nodiscard]] bool accelerometer_active() const;
  ReadyOutput& output(Output which) { return outputs_[static_cast<std::size_t>(which)]; }

  PartClock clock_;
  std::function<Motion(Time)> motion_;
  std::function<double(Time)> temperature_;
  std::array<ReadyOutput, 4> outputs_;
  std::array<std::uint8_t, 128> accel_{}, gyro_{};
  Exchange accel_exchange_, gyro_exchange_;
  bool accel_on_spi_ = false;
  Time accel_ready_ = 0, gyro_ready_ = 0;  ///< not before: resets take their time
  Time accel_sampled_ = 0, gyro_sampled_ = 0;
  Time accel_noticed_ = 0;  ///< the sample whose status was read
  bool converts_ = false;   ///< temperatures
  std::uint64_t converting_ = 0;
};

}  // namespace finemote::emulator
