#include "start.hpp"

#include "finemote/board.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/fault.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/cortex_m4/release.hpp"
#include "runtime/src/start.hpp"

namespace {

// As the runtime's main has it.
constexpr std::int64_t kLongestTick = std::int64_t{finemote::cortex_m4::systick::kMaxInterval} *
                                      finemote::cortex_m4::kNsPerUnit / finemote::cortex_m4::kCyclesPerUnit;
constexpr finemote::detail::ReleaseTimer kTimer{kLongestTick, finemote::cortex_m4::kNsPerUnit, true};

}  // namespace

/// The outputs stay as they are: nobody asked for more.
[[noreturn]] void finemote::stop_safely(Module module, std::uint8_t number, const char*) {
  count_fault(module, number);
  for (;;) asm volatile("");
}

int main() {
  using namespace finemote;
  cortex_m4::start_guards();
  board::start_hardware();
  cortex_m4::start_cycles(0);
  detail::start_robot(finemote_schedule, kTimer);
  cortex_m4::start_releases(finemote_schedule);
  baseline::run();
}
