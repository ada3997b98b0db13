// CAN: frames whose identifiers decide which goes first; motors share those that command them.
#include <algorithm>

#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// Bosch CAN 2.0 A, worst stuffing as in Davis et al. 2007: 55 + 10 n bits for a frame of n <= 8 bytes, interframe
/// space included.
WireUnit unit(std::int64_t write, std::int64_t read, std::int64_t, Mover) {
  const std::int64_t bytes = std::max(write, read);
  const std::int64_t frames = std::max<std::int64_t>(ceil_div(bytes, 8), 1);
  return {add(multiply(55, frames), multiply(10, bytes)), 0, frames};
}

}  // namespace

constinit const BusType kCanBus{
    .kind = BusKind::can,
    .name = "can",
    .port_class = PortClass::can,
    .rate = {.form = &kBitrate, .rule = &kStm32Can, .example = 1'000'000, .may_be_left_out = true},
    .most_devices = 32,       // finemote::CanBus::kMaxSlots
    .most_shared_frames = 5,  // finemote::CanBus::kGroups
    .is_shared = true,
    .is_arbitrated = true,
    .counts_traffic = true,
    .unit = unit,
    .flush = BusType::Flush::shared_frames,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "CanBus", .header = "<finemote/can.hpp>", .supervised = true},
    .slot_class = {.name = "CanSlot", .takes_identifiers = true},
};

}  // namespace finemote::gen
