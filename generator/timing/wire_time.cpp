#include "generator/timing/wire_time.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

struct Bits {
  Ns bits = 0;
  Ns interrupts = 0;
};

Bits i2c(Ns write, Ns read) {
  Bits total{2, 1};
  for (const Ns bytes : {write, read}) {
    if (bytes > 0) total = {total.bits + 1 + 9 + 9 * bytes, total.interrupts + 2 + bytes};
  }
  return total;
}

Bits can(Ns bytes) {
  Bits total;
  do {
    const Ns data = std::min<Ns>(bytes, 8);
    total = {total.bits + 55 + 10 * data, total.interrupts + 1};
    bytes -= data;
  } while (bytes > 0);
  return total;
}

}  // namespace

Ns bits_per_byte(std::string_view format) {
  const Ns parity = format.size() > 1 && format[1] != 'N' ? 1 : 0;
  const Ns stops = format.size() > 2 && format[2] == '2' ? 2 : 1;
  return 1 + 8 + parity + stops;
}

void WireUse::add(const WireRate& rate, Ns write, Ns read) {
  Bits use;
  switch (rate.kind) {
    case BusKind::i2c:
      use = i2c(write, read);
      break;
    case BusKind::can:
      use = can(std::max(write, read));
      break;
    case BusKind::spi:
      use = {8 * std::max(write, read), 2};  // one starts it, one ends it
      break;
    case BusKind::uart:
      use = {rate.bits_per_byte * std::max(write, read), 1};
      break;
    case BusKind::rs485:
      use = {rate.bits_per_byte * (write + read), 2};
      break;
    case BusKind::pwm:
    case BusKind::gpio:
    case BusKind::virtual_bus:
      return;
  }
  wire_ns = timing::add(wire_ns, ceil_div(multiply(use.bits, 1'000'000'000), rate.bits_per_s));
  interrupts += use.interrupts;
}

}  // namespace finemote::gen::timing
