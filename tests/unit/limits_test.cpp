// The generator's figures of what the firmware holds are the runtime's.
#include "generator/descriptor/runtime_limits.hpp"

#include "catch.hpp"
#include "finemote/can.hpp"
#include "finemote/ports.hpp"
#include "finemote/schedule.hpp"

namespace finemote {

namespace limits = gen::runtime_limits;

TEST_CASE("the generator knows what the runtime holds") {
  CHECK(limits::kPeriodTicks == kMaxPeriodTicks);
  CHECK(limits::kBuckets == kMaxBuckets);
  CHECK(limits::kCanGroups == CanBus::kGroups);
  CHECK(limits::kCanSlots == CanBus::kMaxSlots);
  CHECK(limits::kCanFilterBanks * limits::kCanIdsPerBank == CanBus::kMaxIds);
  CHECK(limits::kShortestPwmPeriod == kShortestPwmPeriod);
  CHECK(limits::kLongestPwmPeriod == kLongestPwmPeriod);
}

}  // namespace finemote
