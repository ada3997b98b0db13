// I2C: parts that answer to an address, on two wires; a mux can divide it into channels.
#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// NXP UM10204: start or repeated start, address and every byte with its acknowledge 9 bits, stop and bus-free time 2
/// bits. Service for start, address and each byte; the last byte counts as the end once more. Without a byte the
/// address goes out alone.
WireUnit i2c_unit(const BusExchange& exchange) {
  WireUnit total{2, 0, 1};
  const auto add_message = [&](std::int64_t bytes) {
    total.bits = add(total.bits, add(1 + 9, multiply(9, bytes)));
    total.steps = add(total.steps, add(2, bytes));
  };
  if (exchange.write > 0 || exchange.read == 0) add_message(exchange.write);
  if (exchange.read > 0) add_message(exchange.read);
  return total;
}

}  // namespace

constinit const BusType kI2cBus{
    .kind = BusKind::i2c,
    .name = "i2c",
    .port_class = PortClass::i2c,
    .rate = {.form = &kClock, .rule = &kStm32I2c, .example = 400'000, .may_be_left_out = true, .offers_fastest = true},
    .has_addresses = true,
    .carries_expanders = true,
    .is_shared = true,
    .is_mastered = true,
    .takes_then = true,
    .counts_traffic = true,
    .unit = i2c_unit,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "I2cBus", .header = "<finemote/i2c.hpp>", .supervised = true},
    .slot_class = {.name = "I2cSlot", .takes_route = true},
};

}  // namespace finemote::gen
