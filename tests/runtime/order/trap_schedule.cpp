#include "finemote/schedule.hpp"
#include "trap.hpp"

namespace {

void nothing() {}
constexpr finemote::Bucket buckets[] = {{nothing, 5'000'000, 48, 4, 3}};
constexpr finemote::OrderCheck checks[] = {
    {order::motor.construction_number(), order::arm.construction_number(), "motor", "arm"}};

}  // namespace

extern "C" const finemote::Schedule finemote_schedule{"Trap",  1'000'000, buckets, finemote::Overrun::skip,
                                                      nothing, nothing,   checks};
