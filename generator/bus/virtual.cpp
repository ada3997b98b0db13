// Virtual: a bus without hardware, for devices that talk to nothing.
#include "generator/bus/records.hpp"

namespace finemote::gen {

constinit const BusType kVirtualBus{
    .kind = BusKind::virtual_bus,
    .name = "virtual",
    .port_need = BusType::PortNeed::never,
    .most_devices = std::nullopt,
    .bus_class = {.starts = false},
};

}  // namespace finemote::gen
