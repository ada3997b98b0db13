// What the generated schedule tells the runtime: the buckets, and how to start and stop the robot.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/order.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"
#ifdef FINEMOTE_MONITOR
#include "finemote/monitor.hpp"
#endif

namespace finemote {

/// All devices of one period.
struct Bucket {
  void (*entry)();        ///< the interrupt routine of `line`: runs the bucket
  Duration period;        ///< a multiple of the schedule's tick
  std::uint8_t line;      ///< spare interrupt line it is pended on
  std::uint8_t priority;  ///< interrupt priority level, 0 most urgent; rate monotonic
  std::uint8_t watchdog;  ///< starving: this many own periods in a row without a completed job
};

/// What to do when a bucket is released while its last job is still pending or running.
enum class Overrun : std::uint8_t {
  skip,       ///< count it, call the hook, leave the running job alone
  safe_stop,  ///< additionally bring every actuator to its safe output and run no bucket any more
};

struct Schedule {
  const char* robot;
  Duration tick;         ///< all periods are multiples of it
  View<Bucket> buckets;  ///< shortest period first; at most kMaxBuckets
  Overrun overrun;
  void (*start_buses)();   ///< once, before the first release
  void (*safe_outputs)();  ///< may interrupt every stage; called again and again once stopped
  View<OrderCheck> order;  ///< verified before start_buses()
  /// Asked until it is true, or for 100 ms, before the first release: nothing of what the start-up sent is on a wire,
  /// and nobody's frame waits behind it.
  bool (*buses_quiet)() = nullptr;
};

inline constexpr unsigned kMaxBuckets = 11;
/// Longest period of a bucket [ticks].
inline constexpr std::uint32_t kMaxPeriodTicks = 0x7FFF'FFFF;

/// The end of a job of this bucket (index in Schedule::buckets): the last thing of its routine. Of jobs only the
/// monitor wants to know; the interrupt controller knows which buckets are pending or running, and the release
/// interrupt asks it.
inline void complete([[maybe_unused]] unsigned bucket) {
#ifdef FINEMOTE_MONITOR
  monitor_job(bucket);
#endif
  drain_stores();
}

/// How often the bucket overran.
std::uint32_t overruns(unsigned bucket);

}  // namespace finemote

/// Defined by the generated schedule.cpp, read by the runtime's main.
extern "C" const finemote::Schedule finemote_schedule;

/// May be defined by the user: called from the release interrupt after an overrun was counted. Bounded and short.
extern "C" void finemote_overrun_hook(unsigned bucket);
