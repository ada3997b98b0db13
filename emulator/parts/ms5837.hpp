// MS5837 pressure sensor: PROM, conversions that take their time, 24-bit results (data sheets MS5837-02BA and -30BA).
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "emulator/chip/i2c_line.hpp"
#include "emulator/time.hpp"

namespace finemote::emulator {

class Ms5837 : public I2cPart {
 public:
  enum class Variant { k02BA, k30BA };
  static constexpr std::uint8_t kAddress = 0x76;  ///< on the bus; it can have no other

  /// @param now       the board's time
  /// @param pressure  what acts on the part at a time [Pa]
  Ms5837(Variant variant, std::function<Time()> now, std::function<double(Time)> pressure);

  /// Words 0..6 of the PROM; the upper four bits of the first are its checksum and do not count.
  using Prom = std::array<std::uint16_t, 7>;
  /// Another part of the same kind: its own calibration instead of the data sheet's.
  void calibrate(const Prom& prom);

  bool select(std::uint8_t address, bool read) override;
  bool write(WireByte command) override;
  WireByte read() override;
  void stop() override {}

  /// Told when a conversion of pressure begins. @return what the bytes of its result carry
  std::function<Tag(Time from)> on_sample;
  /// Stops answering: no acknowledge any more.
  bool dead = false;
  /// PROM word 0..6 is read with these bits flipped: a wrong checksum.
  std::uint16_t prom_damage = 0;
  [[nodiscard]] unsigned conversions() const { return conversions_; }
  [[nodiscard]] unsigned early_reads() const { return early_reads_; }

 private:
  void answer(std::uint32_t value, unsigned bytes, Tag origin = Tag::none);
  void convert(bool temperature, unsigned rate);
  [[nodiscard]] std::uint32_t raw_pressure(double pascal) const;

  Variant variant_;
  std::function<Time()> now_;
  std::function<double(Time)> pressure_;
  std::array<std::uint16_t, 8> prom_{};
  std::array<std::uint8_t, 3> answer_{};
  unsigned left_ = 0;
  Time ready_ = 0, busy_until_ = 0;
  std::uint32_t result_ = 0;
  Tag converted_ = Tag::none, answered_ = Tag::none;
  bool converting_ = false;
  unsigned conversions_ = 0, early_reads_ = 0;
};

}  // namespace finemote::emulator
