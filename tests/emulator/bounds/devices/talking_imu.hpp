// An H30 that has a place on a CAN bus, too, from which it takes nothing.
#pragma once

#include <finemote/can.hpp>
#include <finemote/devices/h30_imu.hpp>

namespace testing {

class TalkingImu : public finemote::H30Imu {
 public:
  constexpr TalkingImu(finemote::Uart& uart, finemote::CanSlot&) : H30Imu(nullptr, uart) {}
};

}  // namespace testing
