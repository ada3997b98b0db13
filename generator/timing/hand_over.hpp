// What a root hands down to the devices below it, and they up to it: exactly, or as a closed form that is never
// smaller.
#pragma once

#include <memory>

#include "generator/timing/staircase.hpp"

namespace finemote::gen::timing {

/// What a root hands down to one device, and that device up to the root.
struct HandOver {
  Duration length = nanoseconds(1);  ///< both staircases repeat after it
  std::shared_ptr<const Staircase> down, up;
};

/// The oldest data that any release in one row of the device's release table uses; a root that is its own terminal has
/// age 0.
struct OldestUse {
  Duration age;  ///< terminal release less source release
  Duration release, source;
  std::size_t row = 0;
};

/// Bounds that hold for every release, where a least common multiple is too large to walk (docs/timing.md).
struct ClosedForm {
  Duration age;   ///< terminal release less source release
  Duration down;  ///< terminal release less root release
  Duration up;    ///< root release less source release
};

/// How much older than the terminal the root release can be whose decision it uses: the most of all releases.
/// @param period  of the terminal
Duration oldest_down(const Staircase& down, Duration period, Duration root_period);

/// How much older than the root release the source can be whose state it uses: the most of all releases.
Duration oldest_up(const Staircase& up, Duration root_period);

/// The closed form an exact hand-over continues with.
/// @param period  of its device
ClosedForm closed_form_of(const HandOver& exact, Duration period, Duration root_period);

/// The closed form one edge below a device of `parent_period`: data handed over is at most T_producer - g + lag old at
/// the consumer's release, where g is the common divisor of both periods. Throws Overflow.
ClosedForm one_edge_below(const ClosedForm& above, Duration parent_period, Duration period, const Lags& down,
                          const Lags& up);

/// Devices of one period that share a hand-over.
struct HandOverGroup {
  Duration period = nanoseconds(1);
  std::vector<Rank> devices;
  std::shared_ptr<const HandOver> exact;  ///< null: only `closed` is known
  ClosedForm closed;                      ///< only without `exact`
};

}  // namespace finemote::gen::timing
