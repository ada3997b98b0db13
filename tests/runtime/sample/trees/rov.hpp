// Two periods, one crossing: what the generator writes for such a tree, by hand.
#pragma once

#include <finemote/latch.hpp>

#include "../device.hpp"

namespace Sample::rov {

/// imu: every 5 ms
FINEMOTE_CONSTINIT inline sample::Load imu{200'000, 100'000};
FINEMOTE_CONSTINIT inline sample::Load left{1'000'000, 500'000};
FINEMOTE_CONSTINIT inline sample::Load right{1'000'000, 500'000};

namespace ports {
inline finemote::LatchToSlow<finemote::Stamp> imu_to_rov_latch;   // imu (5 ms) -> rov (10 ms)
inline finemote::Stamp imu_to_rov;
inline finemote::LatchToFast<finemote::Stamp> rov_to_imu_latch;   // rov (10 ms) -> imu (5 ms)
inline finemote::Stamp rov_to_imu;
inline constexpr finemote::Port<finemote::Any> rov_children[] = {
    {imu_to_rov, rov_to_imu}, {left.state, left.command}, {right.state, right.command}};
}  // namespace ports

/// rov: every 10 ms
FINEMOTE_CONSTINIT inline sample::Load rov{2'000'000, 1'000'000, ports::rov_children};

void update_5ms();
void handle_5ms();
void update_10ms();
void handle_10ms();

}  // namespace Sample::rov
