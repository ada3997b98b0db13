// GPIO: single pins that the board file names.
#include "generator/bus/records.hpp"

namespace finemote::gen {

constinit const BusType kGpioBus{
    .kind = BusKind::gpio,
    .name = "gpio",
    .port_need = BusType::PortNeed::where_there_is_one,
    .channels = BusType::Channels::pins,
    .reach = BusType::Reach::pin,
    .bus_class = {.name = "GpioBus", .header = "<finemote/gpio.hpp>"},
};

}  // namespace finemote::gen
