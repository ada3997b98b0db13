// Turns the registers of a BMI088 accelerometer and gyroscope into rates, acceleration and attitude.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/control/attitude.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/geometry.hpp"
#include "finemote/gpio.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/pwm.hpp"
#include "finemote/spi.hpp"

namespace finemote {

/// Two chips in one part, each with its own chip select: the device's bus is the accelerometer's, `use` role `gyro` the
/// gyroscope's. Ranges +-6 g and +-2000 deg/s.
///
/// Nothing waits: every update() takes the two reads of the one before and starts the next two; the state's origin is
/// when they began, less the longest age of what the accelerometer then has. Bring-up (resets, settings, identities) is
/// a state with `valid = false`, which lasts until gravity has been seen once. The gyroscope's identity and the
/// accelerometer's own clock are read along: a part that stands still, is missing or was reset is invalid at once and
/// brought up again after kMaxFailures reads.
///
/// Rates, acceleration and attitude are in the axes of the robot, wherever the URDF says the part's own link
/// points.
///
/// With a pulse output in the use `heater` it holds the part at a temperature, so that the gyroscope's offset stays
/// where it was learned. The heater is off without a temperature that is plausible and new, and in safe(). With the
/// gyroscope's data-ready line in the use `ready` the origin is never later than the edge before the reads, and a
/// gyroscope without edges is invalid.
class Bmi088 {
 public:
  struct Config {
    float kp = 0.5F;            ///< 1/s, see AttitudeFilter
    float ki = 0.01F;           ///< 1/s^2
    float temperature = 40;     ///< to hold [degree C]
    float heater_kp = 0.2F;     ///< share of the heater's power per K
    float heater_ki = 0.005F;   ///< share per K and second
    float heater_limit = 0.5F;  ///< largest share, 0..1
  };
  static constexpr std::uint8_t kMaxFailures = 3;
  static constexpr float kColdest = -20, kHottest = 70;        ///< degree C: beyond them it is not heated
  static constexpr Duration kMaxTemperatureAge = 2 * kSecond;  ///< of the read the temperature came with
  static constexpr Duration kMaxEdgeAge = 5 * kMillisecond;    ///< of the data-ready line

  /// @param mount  takes the part's axes to those wanted; null: they are the same
  constexpr Bmi088(const Config& config, const Rotation* mount, SpiSlot& accelerometer, SpiSlot& gyroscope,
                   PwmChannel* heater = nullptr, EdgePin* ready = nullptr)
      : config_(config), mount_(mount), accel_(&accelerometer), gyro_(&gyroscope), heater_(heater), ready_(ready) {}

  void update();
  void handle();
  /// The heater off, at the next flush. May interrupt update() and handle().
  void safe();

  ImuState state;

  /// Of the part [degree C]; says nothing without a heater.
  [[nodiscard]] float temperature() const { return temperature_; }
  /// Share of its power the heater has, 0..1.
  [[nodiscard]] float heat() const { return heat_; }

 private:
  enum class Step : std::uint8_t { kWait, kSetUp, kCheck, kRun };

  void set_up();
  void check();
  void take_sample();
  [[nodiscard]] bool takes_chip_time();
  void take_temperature(Time at);
  void start_reads();
  void fail();
  void begin_again();

  Config config_;
  const Rotation* mount_;
  SpiSlot* accel_;
  SpiSlot* gyro_;
  PwmChannel* heater_;
  EdgePin* ready_;
  Edge edge_;       ///< before the reads under way
  Time asked_ = 0;  ///< when they were begun
  float temperature_ = 0, heat_ = 0;
  Time warmed_ = 0;  ///< when the temperature was taken; 0: never
  Time regulated_ = 0;
  Pid warmth_;
  Step step_ = Step::kWait;
  std::uint8_t entry_ = 0;     ///< of the set-up table
  std::uint8_t failures_ = 0;  ///< in a row
  bool started_ = false;
  Time wait_until_ = 0;
  Time sampled_ = 0;
  std::uint32_t chip_time_ = 0;  ///< of the last read that was answered
  Time chip_asked_ = 0;          ///< when that was begun
  AttitudeFilter attitude_;
  alignas(std::uint32_t) std::uint8_t accel_out_[20]{};  // aligned: copied by words
  alignas(std::uint32_t) std::uint8_t accel_in_[20]{};
  alignas(std::uint32_t) std::uint8_t gyro_out_[9]{};
  alignas(std::uint32_t) std::uint8_t gyro_in_[9]{};
};

}  // namespace finemote
