// CAN: frames whose identifiers decide which goes first; motors share those that command them.
#include <algorithm>

#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

std::int64_t frames_of(std::int64_t bytes) { return std::max<std::int64_t>(ceil_div(bytes, 8), 1); }

/// Bosch CAN 2.0 A, worst stuffing as in Davis et al. 2007: 55 + 10 n bits for a frame of n <= 8 bytes, interframe
/// space included. What a device reads is an answer to what it writes, which may be a frame without data.
WireUnit can_unit(const BusExchange& exchange) {
  const bool is_polled = exchange.is_asked_for && exchange.read > 0;
  const std::int64_t first = exchange.is_asked_for ? exchange.write : exchange.read;
  const std::int64_t answer = is_polled ? exchange.read : 0;
  const std::int64_t frames = frames_of(first), answers = is_polled ? frames_of(answer) : 0;
  const std::int64_t bits = add(multiply(55, add(frames, answers)), multiply(10, add(first, answer)));
  return {bits, 0, frames, answers};
}

/// Without a stuff bit: 44 bits, 8 for each byte, and three of interframe space.
std::int64_t least_bits(std::int64_t bytes) {
  const std::int64_t last = bytes % 8 == 0 ? std::min<std::int64_t>(bytes, 8) : bytes % 8;
  return 47 + 8 * last;
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
    .unit = can_unit,
    .least_bits = least_bits,
    .flush = BusType::Flush::shared_frames,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "CanBus", .header = "<finemote/can.hpp>", .supervised = true},
    .slot_class = {.name = "CanSlot", .takes_identifiers = true},
};

}  // namespace finemote::gen
