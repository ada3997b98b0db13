// What the image did that the hardware would not forgive, or that the emulator does not know.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "emulator/time.hpp"

namespace finemote::emulator {

enum class Misuse {
  unclocked,        ///< a peripheral was touched before its clock was on
  unmodelled,       ///< a register or bit the emulator does not know
  dma_unreachable,  ///< DMA to or from memory it cannot reach
  clock,            ///< wait states, prescalers or PLL out of range
  late_flag,        ///< an interrupt flag cleared as the last thing of its routine, without read-back
  protocol,         ///< registers used in an order the manual forbids
  wire,             ///< two drivers, wrong format or rate
  fault,            ///< a processor fault
};

constexpr const char* name_of(Misuse misuse) {
  constexpr const char* kNames[] = {"unclocked", "unmodelled", "dma-unreachable", "clock", "late-flag", "protocol",
                                    "wire",      "fault"};
  return kNames[static_cast<unsigned>(misuse)];
}

/// One kind of misuse; the same text is kept once and counted.
struct Report {
  Misuse misuse;
  std::string text;
  std::uint64_t first_ns;
  std::uint32_t pc;
  std::uint32_t count;
  std::optional<std::uint32_t> address;  ///< of the register whose access it was
};

class Reports {
 public:
  void add(Misuse misuse, const std::string& text, Time now, std::uint32_t pc,
           std::optional<std::uint32_t> address = std::nullopt) {
    for (Report& report : reports_) {
      if (report.misuse == misuse && report.text == text) {
        ++report.count;
        return;
      }
    }
    reports_.push_back(Report{misuse, text, to_ns(now), pc, 1, address});
  }
  [[nodiscard]] const std::vector<Report>& all() const { return reports_; }

 private:
  std::vector<Report> reports_;
};

}  // namespace finemote::emulator
