// Turns the raw conversions of an MS5837 into compensated water pressure and temperature.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/i2c.hpp"
#include "finemote/interfaces/pressure.hpp"

namespace finemote {

/// TE Connectivity MS5837-02BA (0.01..2 bar) and MS5837-30BA (0..30 bar).
///
/// Nothing waits: every update() looks at the transfer of the one before and starts the next, which reads the result of
/// one conversion and commands the next one as one unit on the bus. Every kTemperatureEvery-th conversion is one of the
/// temperature, all others of the pressure, and every pressure is published. Bring-up (reset, 20 ms, seven words of
/// PROM, CRC) is the same machine with `valid = false`; a part that stops answering, or three
/// times in a row gives values out of range or far from the last good one, begins again with it.
///
/// `state.origin` is when the pressure conversion was asked for. The state is invalid from a failure to the next good
/// pressure.
class Ms5837 {
 public:
  enum class Variant : std::uint8_t { k02BA, k30BA };

  struct Config {
    Variant variant = Variant::k30BA;
    std::int32_t oversampling = 1024;  ///< 256, 512, ..., 8192
  };

  constexpr Ms5837(const Config& config, I2cSlot& slot)
      : slot_(&slot),
        variant_(config.variant),
        step_size_(step_size(config.oversampling)),
        conversion_(static_cast<std::int32_t>(conversion_time(config.oversampling))) {}

  void update();
  void handle() {}

  PressureState state;

  /// Factory calibration: words 1..6 of the PROM, C1..C6 in the data sheets.
  struct Calibration {
    std::uint16_t c[7] = {};  ///< c[0] holds CRC and version
  };
  /// What the temperature alone decides, in the data sheets' words and units.
  struct FirstOrder {
    std::int64_t dt;           ///< dT, from the reference temperature
    std::int64_t temperature;  ///< TEMP [0.01 degrees Celsius]
    std::int64_t offset, sensitivity;
  };
  /// d2: 24-bit result of the temperature.
  static FirstOrder first_order(Variant variant, const Calibration& calibration, std::uint32_t d2);
  /// 02BA: 0.01 mbar; 30BA: 0.1 mbar. d1: 24-bit result of the pressure.
  static std::int32_t pressure(Variant variant, std::uint32_t d1, std::int64_t offset, std::int64_t sensitivity);

  struct Compensated {
    std::int32_t temperature;  ///< 0.01 degrees Celsius
    std::int32_t pressure;     ///< as pressure()
  };
  /// First and second order compensation, in 64 bits throughout.
  static Compensated compensate(Variant variant, const Calibration& calibration, std::uint32_t d1, std::uint32_t d2);

  /// What the last bring-up has read of it.
  [[nodiscard]] const Calibration& calibration() const { return calibration_; }

  /// CRC-4 of the seven words (bits 15..12 of word 0 do not count); to be compared with those bits.
  static std::uint8_t crc4(const Calibration& calibration);

  /// Longest conversion [ns], data sheets' "ADC conversion time"; 0 for a value that does not exist.
  static constexpr Duration conversion_time(std::int32_t oversampling) {
    switch (oversampling) {
      case 256:
        return 600 * kMicrosecond;
      case 512:
        return 1170 * kMicrosecond;
      case 1024:
        return 2280 * kMicrosecond;
      case 2048:
        return 4540 * kMicrosecond;
      case 4096:
        return 9040 * kMicrosecond;
      case 8192:
        return 18080 * kMicrosecond;
      default:
        return 0;
    }
  }

 private:
  enum class Step : std::uint8_t { kReset, kResetting, kProm, kFirst, kConvert };
  enum class Kind : std::uint8_t { kPressure, kTemperature };
  static constexpr std::uint8_t kTemperatureEvery = 16;
  static constexpr std::uint8_t kBadValues = 3;

  static constexpr std::uint8_t step_size(std::int32_t oversampling) {
    std::uint8_t steps = 0;
    for (std::int32_t n = 256; n < oversampling; n *= 2) ++steps;
    return static_cast<std::uint8_t>(2 * steps);
  }

  void take_result();
  void take_prom_word();
  void take_conversion();
  void conversion_begun(Kind kind);
  void begin_step();
  void begin_convert();
  void publish();
  void bad_value();
  [[nodiscard]] std::uint8_t command(Kind kind) const;

  I2cSlot* const slot_;
  const Variant variant_;
  const std::uint8_t step_size_;  ///< added to the conversion commands
  Step step_ = Step::kReset;
  bool started_ = false;
  bool known_ = false;  ///< there was a good value since the bring-up; the next one must follow it
  Kind running_ = Kind::kTemperature, next_ = Kind::kPressure;
  std::uint8_t word_ = 0;
  std::uint8_t pressures_ = 0;   ///< since the last temperature
  std::uint8_t bad_values_ = 0;  ///< in a row
  std::uint8_t write_[2]{};
  std::uint8_t read_[3]{};
  const std::int32_t conversion_;  ///< ns
  std::uint32_t d1_ = 0, d2_ = 0;
  Time transfer_begun_ = 0;    ///< when the transfer under way was begun
  Time conversion_asked_ = 0;  ///< when the running conversion was asked for
  Time ready_ = 0;             ///< its result, or the part after a reset
  Time d1_asked_ = 0;          ///< when the conversion behind d1_ was asked for
  Calibration calibration_;
};

}  // namespace finemote
