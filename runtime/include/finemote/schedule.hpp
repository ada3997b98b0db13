// What the generated schedule tells the runtime: the buckets, and how to start and stop the robot.
#pragma once

#include <cstddef>
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

/// What the runtime keeps of a bucket. Written by what releases the buckets alone.
struct BucketState {
  std::uint32_t left = 0;      ///< ticks from the last planned instant to its next release
  std::uint32_t period = 0;    ///< [ticks]
  std::uint32_t bit = 0;       ///< what it is in a set of buckets; a bit of its own
  std::uint32_t overruns = 0;  ///< since the start
  std::uint8_t missed = 0;     ///< periods in a row without a completed job
};

/// Room for the states of a schedule of N buckets: an image has as much as its robot needs.
template <std::size_t N>
inline BucketState bucket_states[N]{};

/// The buckets of a schedule, and the room for their states. Made from an array of constants, which outlives it.
class Buckets {
 public:
  constexpr Buckets() = default;  ///< none
  /// All of an array; at most one schedule of a program is made so.
  template <std::size_t N>
  constexpr Buckets(const Bucket (&buckets)[N]) : first_(buckets), count_(N), states_(bucket_states<N>) {}
  /// `count` buckets side by side, and as many states.
  constexpr Buckets(const Bucket* first, std::size_t count, BucketState* states)
      : first_(first), count_(count), states_(states) {}

  [[nodiscard]] constexpr std::size_t size() const { return count_; }  ///< number of buckets
  [[nodiscard]] constexpr bool empty() const { return count_ == 0; }   ///< whether there is none
  /// `i` < size(); not checked.
  constexpr const Bucket& operator[](std::size_t i) const { return first_[i]; }
  [[nodiscard]] constexpr const Bucket* begin() const { return first_; }         ///< for range-based loops
  [[nodiscard]] constexpr const Bucket* end() const { return first_ + count_; }  ///< for range-based loops
  /// Of bucket `i` < size(); not checked. Context: init, release.
  [[nodiscard]] constexpr BucketState& state(std::size_t i) const { return states_[i]; }

 private:
  const Bucket* first_ = nullptr;
  std::size_t count_ = 0;
  BucketState* states_ = nullptr;
};

/// What to do when a bucket is released while its last job is still pending or running.
enum class Overrun : std::uint8_t {
  skip,       ///< count it, call the hook, leave the running job alone
  safe_stop,  ///< additionally bring every actuator to its safe output and run no bucket any more
};

struct Schedule {
  const char* robot;
  Duration tick;    ///< all periods are multiples of it
  Buckets buckets;  ///< shortest period first; at most kMaxBuckets
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
