#include "emulator/outfit/ports.hpp"

#include "emulator/scenario/grammar.hpp"

namespace finemote::emulator {
namespace {

std::string port_of(const Json& event) { return need<std::string>(event, "port"); }
Usart& usart(Board& board, const Json& event) { return *board.chip().usart(port_of(event)); }
I2c& i2c(Board& board, const Json& event) { return *board.chip().i2c(port_of(event)); }
Can& can(Board& board, const Json& event) { return *board.chip().can(port_of(event)); }
Adc& adc(Board& board, const Json& event) { return *board.chip().adc(port_of(event)); }
bool is_on(const Json& event) { return maybe(event, "on", true); }
unsigned count(const Json& event, const char* key) { return need<unsigned>(event, key); }

void break_dma(Board& board, const Json& event) { board.chip().break_dma(port_of(event)); }

/// One row per row of the table's kinds of ports.
struct Row {
  const char *kind, *verb;
  void (*handler)(Board& board, const Json& event);
};
constexpr Row kRows[] = {
    {"serial", "silent", [](Board& b, const Json& e) { usart(b, e).silent = is_on(e); }},
    {"serial", "noise", [](Board& b, const Json& e) { usart(b, e).noisy_bytes = count(e, "bytes"); }},
    {"serial", "dma_error", break_dma},
    {"spi", "dma_error", break_dma},
    {"i2c", "nack",
     [](Board& b, const Json& e) { i2c(b, e).line.nack(need<std::uint8_t>(e, "address"), count(e, "times")); }},
    {"i2c", "hold_sda",
     [](Board& b, const Json& e) { i2c(b, e).line.hold_sda(maybe(e, "clocks", I2cLine::kForever)); }},
    {"i2c", "release_sda", [](Board& b, const Json& e) { i2c(b, e).line.hold_sda(0); }},
    {"i2c", "disturb", [](Board& b, const Json& e) { i2c(b, e).disturbed_starts = count(e, "starts"); }},
    {"i2c", "lose", [](Board& b, const Json& e) { i2c(b, e).lost_starts = count(e, "starts"); }},
    {"can", "disturb", [](Board& b, const Json& e) { can(b, e).line.disturbed_frames = count(e, "frames"); }},
    {"can", "silent", [](Board& b, const Json& e) { can(b, e).line.cut = is_on(e); }},
    {"adc", "volts", [](Board& b, const Json& e) { adc(b, e).volts[count(e, "input")] = need<double>(e, "volts"); }},
    {"adc", "silent", [](Board& b, const Json& e) { adc(b, e).dead = is_on(e); }},
};

}  // namespace

void happen_to_port(Board& board, const Json& event) {
  const scenario::PortKind* kind = scenario::kind_of_port(port_of(event));
  for (const Row& row : kRows) {
    if (kind != nullptr && row.kind == kind->name && row.verb == need<std::string>(event, "do"))
      return row.handler(board, event);
  }
  refuse(event, "this cannot happen to this port");
}

void happen_to_pin(Board& board, const Json& event) {
  const auto pin = need<std::string>(event, "pin"), what = need<std::string>(event, "do");
  const int level = what == "release" ? -1 : what == "high" ? 1 : 0;
  board.chip().gpio(pin[1]).drive(static_cast<unsigned>(std::stoul(pin.substr(2))), level);
}

}  // namespace finemote::emulator
