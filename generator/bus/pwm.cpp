// PWM: outputs that repeat a pulse; a device sets how long its own is.
#include "generator/bus/records.hpp"

namespace finemote::gen {

constinit const BusType kPwmBus{
    .kind = BusKind::pwm,
    .name = "pwm",
    .port_class = PortClass::pwm,
    .channels = BusType::Channels::outputs,
    .flush = BusType::Flush::outputs,
    .reach = BusType::Reach::channel,
    .bus_class = {.name = "PwmBus", .header = "<finemote/pwm.hpp>"},
};

}  // namespace finemote::gen
