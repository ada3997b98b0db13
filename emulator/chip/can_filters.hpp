// The filter banks both CAN controllers share: which FIFO takes an identifier, if any. RM0090 32.7.4.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace finemote::emulator {

class CanFilters {
 public:
  struct Match {
    unsigned fifo = 0;    ///< 0 or 1
    unsigned number = 0;  ///< as the FIFO shows it: filters of a FIFO are counted through the banks, active or not
  };
  /// What takes a standard identifier among the banks of the first, or, for CAN2, the second group.
  [[nodiscard]] std::optional<Match> match(std::uint32_t id, bool second) const;

  /// Nothing: there is no such register. @param offset  from the start of CAN1
  [[nodiscard]] std::optional<std::uint32_t> read(std::uint32_t offset);
  bool write(std::uint32_t offset, std::uint32_t value);
  /// FMR.FINIT: what is written now counts.
  [[nodiscard]] bool is_open() const { return (fmr_ & 1) != 0; }
  static bool is_master(std::uint32_t offset) { return offset == kMaster; }

 private:
  enum Offset : std::uint32_t {
    kMaster = 0x200,
    kMode = 0x204,
    kScale = 0x20C,
    kFifo = 0x214,
    kActive = 0x21C,
    kBanks = 0x240
  };
  static constexpr unsigned kCount = 28;
  /// How a filter stands to others that match too: 32 bits before 16, a list before a mask, then the lower number.
  struct Rank {
    bool wide, list;
    unsigned number;
    [[nodiscard]] bool goes_before(const Rank& other) const;
  };
  [[nodiscard]] std::uint32_t* place(std::uint32_t offset);
  /// Which of the bank's filters takes the identifier; nothing: none.
  [[nodiscard]] std::optional<unsigned> match_in(unsigned bank, std::uint32_t id) const;
  /// Filters in a bank: one mask or two identifiers of 32 bits, two or four of 16.
  [[nodiscard]] unsigned filters_in(unsigned bank) const {
    return 1U << ((mode_ >> bank & 1) + 1 - (scale_ >> bank & 1));
  }

  std::uint32_t fmr_ = 0x2A1C0E01, mode_ = 0, scale_ = 0, fifo_ = 0, active_ = 0;
  std::array<std::uint32_t, 2 * kCount> banks_{};
};

}  // namespace finemote::emulator
