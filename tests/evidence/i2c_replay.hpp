// Gives a part model of the emulator one exchange of an I2C bus.
#pragma once

#include <optional>

#include "emulator/chip/i2c_line.hpp"
#include "tests/evidence/vectors.hpp"

namespace finemote::evidence {

/// What the part answers, as many bytes as the exchange has; nothing where it does not acknowledge.
inline std::optional<Bytes> exchange(emulator::I2cPart& part, const Exchange& asked) {
  const auto address = static_cast<std::uint8_t>(asked.address.value_or(0));
  Bytes answer;
  bool acknowledged = true;
  if (!asked.written.empty()) {
    acknowledged = part.select(address, false);
    for (const std::uint8_t byte : asked.written) acknowledged = acknowledged && part.write(byte);
  }
  if (acknowledged && !asked.read.empty()) {
    acknowledged = part.select(address, true);
    while (acknowledged && answer.size() < asked.read.size()) answer.push_back(part.read());
  }
  part.stop();
  if (!acknowledged) return {};
  return answer;
}

}  // namespace finemote::evidence
