// SPI: parts that are selected by a pin each, full duplex.
#include <algorithm>

#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// Without a DMA every byte is a step; the last one counts as the end once more.
WireUnit spi_unit(const BusExchange& exchange) {
  const std::int64_t bytes = std::max(exchange.write, exchange.read);
  return {multiply(8, bytes), exchange.mover == Mover::dma ? 0 : bytes, 1};
}

}  // namespace

constinit const BusType kSpiBus{
    .kind = BusKind::spi,
    .name = "spi",
    .port_class = PortClass::spi,
    .rate = {.form = &kClock, .rule = &kStm32Spi, .example = 5'250'000},
    .channels = BusType::Channels::selects,
    .is_mastered = true,
    .is_both_ways = true,
    .longest = {.written = 64, .read = 64, .with_dma = true},
    .counts_traffic = true,
    .unit = spi_unit,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "SpiBus", .header = "<finemote/spi.hpp>", .supervised = true},
    .slot_class = {.name = "SpiSlot", .takes_mode = true},
};

}  // namespace finemote::gen
