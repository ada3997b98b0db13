#include "runtime/chips/cortex_m4/urgent_interrupt.hpp"

#include "finemote/single_core.hpp"
#include "runtime/chips/cortex_m4/core.hpp"

namespace finemote::cortex_m4 {
namespace {

/// Cycles from the end of one routine to the begin of the next where nothing runs in between: tail-chaining (6, Arm DDI
/// 0439 3.9) and the last and first instructions of both, which fetches from flash may make several times as long.
constexpr std::uint32_t kPause = 320;

/// From an event to the begin of its routine where no other one is in the way: what `exception_entry`, `preemption` and
/// `masked_section` of the chip's file allow together.
constexpr Duration kEntry = 1'600;

/// The last routine that ended [cycles]: since when it, or those it followed, ran. Only routines of one priority use
/// it, which do not interrupt each other.
struct Chain {
  std::uint32_t begun, ended;
} chain;

}  // namespace

UrgentInterrupt::UrgentInterrupt() {
  const std::uint32_t present = cycles();
  begun_ = present - chain.ended < kPause ? chain.begun : present;
}

UrgentInterrupt::~UrgentInterrupt() {
  chain = {begun_, cycles()};
  drain_stores();
}

Moment UrgentInterrupt::event() const {
  const Time present = now();
  if (present == 0) return {};  // before the first release
  const std::uint32_t since = cycles() - begun_;
  return {present - since * kNsPerUnit / kCyclesPerUnit - kEntry, present};
}

}  // namespace finemote::cortex_m4
