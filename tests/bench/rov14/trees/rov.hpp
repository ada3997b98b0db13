// The ROV of 14 devices: an IMU every 5 ms; four pressure sensors, eight thrusters and the root every 10 ms.
#pragma once

#include <finemote/latch.hpp>

#include "../device.hpp"

namespace Rov14::rov {

FINEMOTE_CONSTINIT inline bench::Empty imu{0};
FINEMOTE_CONSTINIT inline bench::Empty baro_1{1};
FINEMOTE_CONSTINIT inline bench::Empty baro_2{2};
FINEMOTE_CONSTINIT inline bench::Empty baro_3{3};
FINEMOTE_CONSTINIT inline bench::Empty baro_4{4};
FINEMOTE_CONSTINIT inline bench::Empty thruster_1{5};
FINEMOTE_CONSTINIT inline bench::Empty thruster_2{6};
FINEMOTE_CONSTINIT inline bench::Empty thruster_3{7};
FINEMOTE_CONSTINIT inline bench::Empty thruster_4{8};
FINEMOTE_CONSTINIT inline bench::Empty thruster_5{9};
FINEMOTE_CONSTINIT inline bench::Empty thruster_6{10};
FINEMOTE_CONSTINIT inline bench::Empty thruster_7{11};
FINEMOTE_CONSTINIT inline bench::Empty thruster_8{12};
FINEMOTE_CONSTINIT inline bench::Empty rov{13};

namespace ports {
inline finemote::LatchToSlow<finemote::Imu::State> imu_to_rov_latch;  // imu (5 ms) -> rov (10 ms)
inline finemote::Imu::State imu_to_rov;
}  // namespace ports

void update_5ms();
void handle_5ms();
void update_10ms();
void handle_10ms();

}  // namespace Rov14::rov
