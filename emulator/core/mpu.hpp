// The memory protection unit: who may write and execute where. PM0214 4.2, ARMv7-M B3.5.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace finemote::emulator {

/// One of its regions: RBAR and RASR.
struct MpuRegion {
  std::uint32_t base = 0, attributes = 0;
  [[nodiscard]] bool enabled() const { return (attributes & 1) != 0; }
  [[nodiscard]] std::uint64_t bytes() const { return std::uint64_t{2} << ((attributes >> 1) & 0x1F); }
  [[nodiscard]] std::uint32_t access() const { return (attributes >> 24) & 7; }
  [[nodiscard]] bool execute_never() const { return (attributes >> 28 & 1) != 0; }
  /// Not where one of its eight parts is turned off: B3.5.3.
  [[nodiscard]] bool covers(std::uint32_t address) const;
};

/// For privileged code, which is all there is. Reads are not judged.
class Mpu {
 public:
  void reset() { *this = {}; }
  /// MPU_CTRL, MPU_RNR, MPU_RBAR and MPU_RASR with their aliases; nothing: another register.
  [[nodiscard]] std::optional<std::uint32_t> read(std::uint32_t address) const;
  /// @return false: another register
  bool write(std::uint32_t address, std::uint32_t value);

  [[nodiscard]] bool may_write(std::uint32_t address) const;
  [[nodiscard]] bool may_execute(std::uint32_t address) const;
  /// Whether all of these bytes may be executed.
  [[nodiscard]] bool may_execute(std::uint32_t address, std::uint32_t bytes) const;
  /// The end of the last of these bytes that may not be written; `address`: all may.
  [[nodiscard]] std::uint32_t end_of_protected(std::uint32_t address, std::uint32_t bytes) const;
  /// The lowest and the end address of a region in RAM that nobody may touch; else 0, 0.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> guard() const;

 private:
  [[nodiscard]] bool is_on() const { return (control_ & 1) != 0; }
  [[nodiscard]] const MpuRegion* region_at(std::uint32_t address) const;
  [[nodiscard]] bool has_background() const { return (control_ & 4) != 0; }
  [[nodiscard]] std::vector<std::uint32_t> borders(std::uint32_t address, std::uint32_t bytes) const;

  std::uint32_t control_ = 0, number_ = 0;
  std::array<MpuRegion, 8> regions_{};
};

}  // namespace finemote::emulator
