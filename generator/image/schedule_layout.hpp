// Where the members of finemote::Schedule and finemote::Bucket lie on the target: runtime/chips/cortex_m4/release.cpp
// asserts it.
#pragma once

#include <cstdint>

namespace finemote::gen::schedule_layout {

inline constexpr std::uint32_t kRobotAt = 0, kBucketsAt = 16, kBucketCountAt = 20, kStartBusesAt = 32,
                               kSafeOutputsAt = 36, kBusesQuietAt = 48;
inline constexpr std::uint32_t kBucketSize = 24, kPeriodAt = 8, kLineAt = 16;

}  // namespace finemote::gen::schedule_layout
