// The functions that a walk is in, and what keeps it from entering another.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "generator/wcet/walk.hpp"

namespace finemote::gen::wcet {

/// The functions that are gone through, outermost first, each with the call that led to it.
class CallChain {
 public:
  /// Why a function cannot be entered; null: it can.
  [[nodiscard]] const char* why_not(std::uint32_t address, const ProgramFunction* function, std::uint32_t from) const {
    if (function == nullptr) return "a call of what is no function";
    if (is_in_flash(address) != is_in_flash(from)) return "a call between code in SRAM and code in flash";
    if (has(function)) return "recursion: it has no bound";
    return open_.size() == kDeepest ? "more than 64 calls in each other" : nullptr;
  }
  void enter(const ProgramFunction* function, std::uint32_t from) { open_.push_back({function, from}); }
  void leave() { open_.pop_back(); }

  /// Innermost first.
  [[nodiscard]] std::vector<CallSite> sites() const {
    std::vector<CallSite> sites;
    for (std::size_t i = open_.size(); i-- > 1;) sites.push_back({open_[i].from, open_[i - 1].function});
    return sites;
  }

 private:
  static constexpr std::size_t kDeepest = 64;
  [[nodiscard]] static bool is_in_flash(std::uint32_t address) { return address >> 24 == 0x08; }
  [[nodiscard]] bool has(const ProgramFunction* function) const {
    return std::any_of(open_.begin(), open_.end(), [&](const Open& open) { return open.function == function; });
  }

  struct Open {
    const ProgramFunction* function;
    std::uint32_t from;
  };
  std::vector<Open> open_;
};

}  // namespace finemote::gen::wcet
