// The far end of a serial line: sends what it is told, remembers what it hears and when.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emulator/chip/peripheral.hpp"
#include "emulator/chip/usart.hpp"

namespace finemote::emulator {

class SerialTerminal {
 public:
  struct Heard {
    Time at;  ///< last stop bit
    std::uint8_t byte;
  };

  SerialTerminal(World& world, Usart& usart, const SerialFormat& format) : usart_(usart), format_(format) {
    usart.on_sent = [this, &world](WireByte byte) { heard_.push_back(Heard{world.now(), byte.value}); };
  }

  void send(const std::string& text) { usart_.send_in({text.begin(), text.end()}, format_); }
  void send(const std::vector<std::uint8_t>& bytes) { usart_.send_in(bytes, format_); }
  [[nodiscard]] const std::vector<Heard>& heard() const { return heard_; }
  [[nodiscard]] std::string text() const {
    std::string result;
    for (const Heard& it : heard_) result += static_cast<char>(it.byte);
    return result;
  }

 private:
  Usart& usart_;
  SerialFormat format_;
  std::vector<Heard> heard_;
};

}  // namespace finemote::emulator
