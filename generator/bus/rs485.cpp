// RS-485: a serial line that several parts share, one of them sending at a time.
#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

WireUnit rs485_unit(const BusExchange& exchange) {
  return {multiply(exchange.bits_per_byte, add(exchange.write, exchange.read)), 1, 1};
}

}  // namespace

constinit const BusType kRs485Bus{
    .kind = BusKind::rs485,
    .name = "rs485",
    .port_class = PortClass::uart,
    .rate = {.form = &kBaud, .rule = &kStm32Usart, .example = 115'200},
    .has_direction = true,
    .is_polled = true,
    .longest = {.written = 128, .read = 32},
    .unit = rs485_unit,
    .reach = BusType::Reach::slot,
    .bus_class = {.name = "Rs485", .header = "<finemote/rs485.hpp>", .supervised = true},
    .slot_class = {.name = "Rs485Slot"},
};

}  // namespace finemote::gen
