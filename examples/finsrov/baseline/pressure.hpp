// The four MS5837 of the robot behind its multiplexer, by transfers that return when they have ended.
//
// The formula is the runtime's (Ms5837::compensate); what is on the wire are the same bytes as of its driver: a result
// is read with 0x00, a conversion is asked for with 0x48 or 0x58.
#pragma once

#include "finemote/devices/ms5837.hpp"

namespace baseline {

class PressureSensor {
 public:
  enum class Kind : std::uint8_t { pressure, temperature };

  /// @param channel  of the multiplexer, 0 to 7
  constexpr explicit PressureSensor(std::uint8_t channel) : channel_(channel) {}

  /// Reset, calibration, the first conversion. Takes 25 ms. Context: start.
  void start();

  bool select() const;
  bool begin(Kind kind);
  /// The result of the conversion that was begun last; 0 where it cannot be had.
  std::uint32_t result() const;

  /// A competent driver's turn: takes the result, and begins the next conversion, every sixteenth one of the
  /// temperature. The state is valid while values come. Selects the sensor first.
  void turn();

  /// Makes a pressure of the two last results, whatever became of them.
  void compute();
  void set_temperature(std::uint32_t result) { temperature_ = result; }
  void set_pressure(std::uint32_t result);

  finemote::PressureState state;

 private:
  void publish();

  const std::uint8_t channel_;
  Kind running_ = Kind::temperature;
  std::uint8_t pressures_ = 0;  ///< since the last temperature
  std::uint32_t temperature_ = 0, pressure_ = 0;
  finemote::Time begun_ = 0, pressure_begun_ = 0;
  finemote::Ms5837::Calibration calibration_;
};

}  // namespace baseline
