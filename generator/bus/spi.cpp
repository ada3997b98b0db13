// SPI: parts that are selected by a pin each, full duplex.
#include <algorithm>

#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// One interrupt starts it, one ends it.
WireUnit unit(std::int64_t write, std::int64_t read, std::int64_t) { return {multiply(8, std::max(write, read)), 2}; }

}  // namespace

constinit const BusType kSpiBus{
    .kind = BusKind::spi,
    .name = "spi",
    .port_class = PortClass::spi,
    .rate = {.form = &kClock, .rule = &kStm32Spi, .example = 5'250'000},
    .channels = BusType::Channels::selects,
    .is_mastered = true,
    .counted = BusType::Counted::by_dma,
    .unit = unit,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "SpiBus", .header = "<finemote/spi.hpp>", .supervised = true},
    .slot_class = {.name = "SpiSlot", .takes_mode = true},
};

}  // namespace finemote::gen
