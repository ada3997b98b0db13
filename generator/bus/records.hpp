// The records of all kinds of bus, for the table in bus_types.cpp alone: others ask bus_type().
#pragma once

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {

extern const BusType kUartBus;
extern const BusType kRs485Bus;
extern const BusType kI2cBus;
extern const BusType kSpiBus;
extern const BusType kCanBus;
extern const BusType kPwmBus;
extern const BusType kGpioBus;
extern const BusType kVirtualBus;

}  // namespace finemote::gen
