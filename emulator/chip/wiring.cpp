#include "emulator/chip/wiring.hpp"

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

PinPlace signal(const Json& port, const char* name) {
  for (const Json& pin : port.at("pins")) {
    if (pin.at("signal") == name) return pin_place(pin.at("pin").get<std::string>());
  }
  return pin_place(port.at("pins").at(0).at("pin").get<std::string>());
}

bool serves(const Json& port, const char* kind) {
  for (const Json& bus : port.at("buses")) {
    if (bus == kind) return true;
  }
  return false;
}

void read_port(const Json& port, Wiring& wiring) {
  const auto name = port.at("name").get<std::string>();
  if (serves(port, "i2c")) wiring.i2cs.push_back({name, signal(port, "scl"), signal(port, "sda")});
  if (port.contains("selects")) {
    for (const Json& pin : port.at("selects")) wiring.selects.push_back({name, pin_place(pin.get<std::string>())});
  }
  if (port.contains("timer")) {
    const Json& timer = port.at("timer");
    wiring.pulses.push_back({name, timer.at("name").get<std::string>(), timer.at("channel").get<unsigned>(),
                             pin_place(port.at("pins").at(0).at("pin").get<std::string>())});
  }
}

}  // namespace

PinPlace pin_place(const std::string& name) { return {name.at(1), static_cast<unsigned>(std::stoul(name.substr(2)))}; }

Wiring read_wiring(const Json& board) {
  Wiring wiring;
  wiring.crystal_hz = board.at("clocks").at("crystal_hz").get<std::uint32_t>();
  for (const Json& port : board.at("ports")) read_port(port, wiring);
  return wiring;
}

}  // namespace finemote::emulator
