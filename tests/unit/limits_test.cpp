// The generator's figures of what the firmware holds are the runtime's.
#include "generator/descriptor/runtime_limits.hpp"

#include "catch.hpp"
#include "finemote/can.hpp"
#include "finemote/ports.hpp"
#include "finemote/schedule.hpp"
#include "generator/bus/bus_type.hpp"

namespace finemote {

namespace limits = gen::runtime_limits;

TEST_CASE("the generator knows what the runtime holds") {
  CHECK(limits::kPeriodTicks == kMaxPeriodTicks);
  CHECK(limits::kBuckets == kMaxBuckets);
  CHECK(gen::bus_type(gen::BusKind::can).most_shared_frames == CanBus::kGroups);
  CHECK(gen::bus_type(gen::BusKind::can).most_devices == CanBus::kMaxSlots);
  CHECK(limits::kShortestPwmPeriod.ns() == kShortestPwmPeriod);
  CHECK(limits::kLongestPwmPeriod.ns() == kLongestPwmPeriod);
}

}  // namespace finemote
