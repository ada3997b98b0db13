#include "generator/timing/bus_traffic.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

using Counted = BusTraffic::Counted;

UnitBits uart_unit(Ns write, Ns read, Ns bits_per_byte) { return {bits_per_byte * std::max(write, read), 1}; }

UnitBits rs485_unit(Ns write, Ns read, Ns bits_per_byte) { return {bits_per_byte * (write + read), 2}; }

/// NXP UM10204: start or repeated start, address and every byte with its acknowledge 9 bits, stop and bus-free time 2
/// bits; service for start, address, each byte and the end.
UnitBits i2c_unit(Ns write, Ns read, Ns) {
  UnitBits total{2, 1};
  for (const Ns bytes : {write, read}) {
    if (bytes > 0) total = {total.bits + 1 + 9 + 9 * bytes, total.interrupts + 2 + bytes};
  }
  return total;
}

/// Full duplex; one interrupt starts it, one ends it.
UnitBits spi_unit(Ns write, Ns read, Ns) { return {8 * std::max(write, read), 2}; }

/// Bosch CAN 2.0 A, worst stuffing as in Davis et al. 2007: 55 + 10 n bits for a frame of n <= 8 bytes, interframe
/// space included.
UnitBits can_unit(Ns write, Ns read, Ns) {
  UnitBits total;
  Ns bytes = std::max(write, read);
  do {
    const Ns data = std::min<Ns>(bytes, 8);
    total = {total.bits + 55 + 10 * data, total.interrupts + 1};
    bytes -= data;
  } while (bytes > 0);
  return total;
}

constexpr BusTraffic kUart{.unit = uart_unit, .has_two_lines = true};
constexpr BusTraffic kRs485{.unit = rs485_unit};
constexpr BusTraffic kI2c{.unit = i2c_unit, .is_mastered = true, .counted = Counted::always, .is_shared = true};
constexpr BusTraffic kSpi{.unit = spi_unit, .is_mastered = true, .counted = Counted::by_dma};
constexpr BusTraffic kCan{.unit = can_unit, .is_arbitrated = true, .is_shared = true};
constexpr BusTraffic kNoFrames{};

}  // namespace

const BusTraffic& traffic_of(BusKind kind) {
  switch (kind) {
    case BusKind::uart:
      return kUart;
    case BusKind::rs485:
      return kRs485;
    case BusKind::i2c:
      return kI2c;
    case BusKind::spi:
      return kSpi;
    case BusKind::can:
      return kCan;
    case BusKind::pwm:
    case BusKind::gpio:
    case BusKind::virtual_bus:
      break;
  }
  return kNoFrames;
}

Ns bits_per_byte(std::string_view format) {
  const Ns parity = format.size() > 1 && format[1] != 'N' ? 1 : 0;
  const Ns stops = format.size() > 2 && format[2] == '2' ? 2 : 1;
  return 1 + 8 + parity + stops;
}

void WireUse::add(const WireRate& rate, Ns write, Ns read) {
  const BusTraffic& traffic = traffic_of(rate.kind);
  if (traffic.unit == nullptr) return;
  const UnitBits use = traffic.unit(write, read, rate.bits_per_byte);
  wire_ns = gen::add(wire_ns, ceil_div(multiply(use.bits, 1'000'000'000), rate.bits_per_s));
  interrupts += use.interrupts;
}

}  // namespace finemote::gen::timing
