#include "emulator/core/nvic.hpp"

namespace finemote::emulator {

void Nvic::set_line(int line, bool high) {
  const int exception = 16 + line;
  const bool rises = high && !level_[index(exception)];
  if (!high && level_[index(exception)]) lowered_ = line;
  level_[index(exception)] = high;
  if (rises) pend(exception);
}

void Nvic::pend(int exception) {
  if (!pending_[index(exception)]) ++pending_count_;
  pending_[index(exception)] = true;
  changed_ = true;
}

void Nvic::unpend(int exception) {
  if (pending_[index(exception)]) --pending_count_;
  pending_[index(exception)] = false;
  if (level_[index(exception)] && !active_[index(exception)]) pend(exception);
}

void Nvic::enable(int exception, bool on) {
  enabled_[index(exception)] = on;
  changed_ = true;
}

int Nvic::priority(int exception) const {
  if (exception <= kHardFault) return exception - 4;
  return priority_[index(exception)];
}

int Nvic::active_priority() const {
  int lowest = 256;
  for (int e = kReset; e < kExceptions; ++e) {
    if (active_[index(e)] && priority(e) < lowest) lowest = priority(e);
  }
  return lowest;
}

int Nvic::most_urgent() const {
  if (pending_count_ == 0) return 0;
  int best = 0, best_priority = 256;
  for (int e = kNmi; e < kExceptions; ++e) {
    const bool gated = e >= 16 || (e >= kMemManage && e <= kUsageFault);
    if (!pending_[index(e)] || (gated && !enabled_[index(e)])) continue;
    if (priority(e) < best_priority) {
      best = e;
      best_priority = priority(e);
    }
  }
  return best;
}

void Nvic::enter(int exception) {
  if (pending_[index(exception)]) --pending_count_;
  pending_[index(exception)] = false;
  active_[index(exception)] = true;
  ++entered_[index(exception)];
}

void Nvic::leave(int exception) {
  active_[index(exception)] = false;
  if (level_[index(exception)] && !pending_[index(exception)]) pend(exception);
  changed_ = true;
}

}  // namespace finemote::emulator
