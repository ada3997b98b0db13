// Models of the I2C parts the drivers speak to, for the host board: what the data sheets say they do.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "finemote/devices/ms5837.hpp"
#include "runtime/boards/host/ports/i2c_wire.hpp"

namespace finemote::host {

/// TCA9548A switch: one control byte; parts answer through the connected channels.
class Tca9548aPart : public I2cPart {
 public:
  /// Hangs a part behind a channel, 0..7; it outlives the switch.
  void connect(unsigned channel, std::uint8_t address, I2cPart& part) { parts_[channel][address] = &part; }

  bool write(const std::vector<std::uint8_t>& bytes) override;
  bool read(std::size_t size, std::vector<std::uint8_t>& bytes) override;
  void reset() override { channels_ = 0; }
  I2cPart* behind(std::uint8_t address) override;

  bool silent = false;                                               ///< answers to nothing
  [[nodiscard]] std::uint8_t channels() const { return channels_; }  ///< connected now, bit n: channel n

 private:
  std::uint8_t channels_ = 0;
  std::map<std::uint8_t, I2cPart*> parts_[8];
};

/// PCA9685 PWM controller: its registers, and the pulses they make.
class Pca9685Part : public I2cPart {
 public:
  Pca9685Part() { reset(); }  ///< asleep, as after power-on

  bool write(const std::vector<std::uint8_t>& bytes) override;
  bool read(std::size_t size, std::vector<std::uint8_t>& bytes) override;
  void reset() override;

  /// Pulse width [ns] at a channel's pin, rounded; 0 while asleep or switched off.
  [[nodiscard]] std::uint32_t pulse(unsigned channel) const;
  /// What stands in a register.
  [[nodiscard]] std::uint8_t reg(std::uint8_t address) const { return registers_[address]; }

  /// What a write has made of the outputs.
  struct Change {
    Time at;                               ///< of the write
    std::array<std::uint32_t, 16> pulses;  ///< ns, by channel
  };
  std::vector<Change> changes;  ///< pulses after every write
  bool silent = false;          ///< answers to nothing

 private:
  std::array<std::uint8_t, 256> registers_{};
  std::uint8_t pointer_ = 0;
};

/// MS5837 pressure sensor: PROM with CRC, conversions that take their time, a world with pressure and temperature.
class Ms5837Part : public I2cPart {
 public:
  /// At 101325 Pa and 20 degrees Celsius.
  explicit Ms5837Part(Ms5837::Variant variant = Ms5837::Variant::k30BA);

  bool write(const std::vector<std::uint8_t>& bytes) override;
  bool read(std::size_t size, std::vector<std::uint8_t>& bytes) override;
  void reset() override;

  /// The world: Pa and degrees Celsius. Met to within the resolution of the part.
  void set(double pressure, double temperature);

  bool silent = false;              ///< answers to nothing
  bool bad_prom = false;            ///< one bit of the PROM is flipped
  std::uint32_t noise = 0;          ///< these bits of every result are flipped
  unsigned conversions = 0;         ///< begun so far
  Ms5837::Calibration calibration;  ///< what its PROM holds

 private:
  Ms5837::Variant variant_;
  std::uint32_t d1_ = 0, d2_ = 0;
  std::uint8_t command_ = 0;
  Time ready_ = 0, reset_until_ = 0;
  std::uint32_t running_ = 0, result_ = 0;
};

}  // namespace finemote::host
