#include "emulator/core/nvic.hpp"

#include <bit>

namespace finemote::emulator {
namespace {

constexpr std::uint64_t bit(int exception) { return std::uint64_t{1} << exception; }

/// NMI, hard fault, SVCall, PendSV and SysTick cannot be disabled; the other faults and all lines can.
constexpr std::uint64_t kAlwaysEnabled = 0xFFFCU & ~(bit(kMemManage) | bit(kBusFault) | bit(kUsageFault));

}  // namespace

void Nvic::set_line(int line, bool high) {
  const int exception = 16 + line;
  if (level_.has(exception) == high) return;
  if (!high) lowered_ = line;
  level_.put(exception, high);
  if (high) pend(exception);
}

void Nvic::pend(int exception) {
  if (on_due && !pending_.has(exception)) on_due(exception);
  pending_.put(exception, true);
  changed_ = true;
}

void Nvic::unpend(int exception) {
  pending_.put(exception, false);
  if (level_.has(exception) && !active_.has(exception)) pend(exception);
}

void Nvic::enable(int exception, bool on) {
  enabled_.put(exception, on);
  changed_ = true;
}

int Nvic::priority(int exception) const {
  return exception <= kHardFault ? exception - 4 : group_of(priority_[index(exception)]);
}

int Nvic::lowest_active() const {
  int lowest = 256;
  for (std::size_t word = 0; word < active_.words.size(); ++word) {
    for (std::uint64_t left = active_.words[word]; left != 0; left &= left - 1) {
      const int p = priority(static_cast<int>(64 * word) + std::countr_zero(left));
      if (p < lowest) lowest = p;
    }
  }
  return lowest;
}

int Nvic::most_urgent() const {
  int best = 0, best_priority = 256;
  for (std::size_t word = 0; word < pending_.words.size(); ++word) {
    std::uint64_t left = pending_.words[word] & (enabled_.words[word] | (word == 0 ? kAlwaysEnabled : 0));
    for (; left != 0; left &= left - 1) {
      const int exception = static_cast<int>(64 * word) + std::countr_zero(left);
      if (whole_priority(exception) < best_priority) {
        best = exception;
        best_priority = whole_priority(exception);
      }
    }
  }
  return best;
}

void Nvic::enter(int exception) {
  pending_.put(exception, false);
  active_.put(exception, true);
  active_priority_ = lowest_active();
  ++entered_[index(exception)];
}

void Nvic::leave(int exception) {
  active_.put(exception, false);
  active_priority_ = lowest_active();
  if (level_.has(exception)) pend(exception);
  changed_ = true;
}

}  // namespace finemote::emulator
