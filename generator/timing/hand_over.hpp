// What a root hands down to the devices below it, and they up to it: exactly, or as a closed form that is never
// smaller.
#pragma once

#include <memory>

#include "generator/timing/staircase.hpp"

namespace finemote::gen::timing {

/// What a root hands down to one device, and that device up to the root.
struct HandOver {
  Ns length = 1;  ///< both staircases repeat after it
  std::shared_ptr<const Staircase> down, up;
};

/// The oldest data that any release in one row of the device's release table uses; a root that is its own terminal has
/// age 0.
struct OldestUse {
  Ns age = 0;  ///< terminal release less source release
  Ns release = 0, source = 0;
  std::size_t row = 0;
};

/// Bounds that hold for every release, where a least common multiple is too large to walk (docs/timing.md).
struct ClosedForm {
  Ns age = 0;   ///< terminal release less source release
  Ns down = 0;  ///< terminal release less root release
  Ns up = 0;    ///< root release less source release
};

/// The closed form an exact hand-over continues with.
/// @param period  of its device
ClosedForm closed_form_of(const HandOver& exact, Ns period, Ns root_period);

/// The closed form one edge below a device of `parent_period`: data handed over is at most T_producer - g + lag old at
/// the consumer's release, where g is the common divisor of both periods. Throws Overflow.
ClosedForm one_edge_below(const ClosedForm& above, Ns parent_period, Ns period, const Lags& down, const Lags& up);

/// Devices of one period that share a hand-over.
struct HandOverGroup {
  Ns period = 1;
  std::vector<Rank> devices;
  std::shared_ptr<const HandOver> exact;  ///< null: only `closed` is known
  ClosedForm closed;                      ///< only without `exact`
};

}  // namespace finemote::gen::timing
