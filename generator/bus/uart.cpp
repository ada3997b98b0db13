// UART: a serial line that connects two ends, each direction on a wire of its own.
#include "generator/bus/records.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// What is read in one frame with what is written answers it.
WireUnit uart_unit(const BusExchange& exchange) {
  return {multiply(exchange.bits_per_byte, add(exchange.write, exchange.read)), 0, 1};
}

}  // namespace

constinit const BusType kUartBus{
    .kind = BusKind::uart,
    .name = "uart",
    .port_class = PortClass::uart,
    .rate = {.form = &kBaud, .rule = &kStm32Usart, .example = 115'200},
    .is_for_one = true,
    .has_line_format = true,
    .has_two_lines = true,
    .longest = {.written = 128, .read = std::nullopt},
    .counts_traffic = true,
    .unit = uart_unit,
    .reach = BusType::Reach::bus,
    .bus_class = {.name = "Uart", .header = "<finemote/uart.hpp>"},
};

}  // namespace finemote::gen
