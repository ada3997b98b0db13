// A program on a computer that commands a robot over a serial line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emulator/parts/frame_sender.hpp"

namespace finemote::emulator {

/// What the program wants of everything that it commands: the same number.
struct SentCommands {
  bool valid = true;
  double value = 0;
};

/// The bytes of one frame (docs/reference/devices/host_link.md): 0xA5 0x5A, kind and block, size, layout, sequence, a
/// payload, and a sum over all but the first two.
/// @param values  a letter for each value of the payload, as struct of Python has them; `v`: validity
std::vector<std::uint8_t> command_frame(std::uint32_t layout, std::uint8_t sequence, const std::string& values,
                                        const SentCommands& commands);

class Computer : public FrameSender {
 public:
  struct Link {
    std::uint32_t layout = 0;
    std::string values;  ///< as for command_frame(); empty: it sends nothing
  };
  /// @param period  between the beginnings of two frames; the first begins after `phase`
  Computer(World& world, Usart& usart, const SerialFormat& format, Link link, Time period, Time phase);

  SentCommands commands;

 private:
  std::vector<std::uint8_t> make_frame(Time now) override;

  Link link_;
  std::uint8_t sequence_ = 0;
};

}  // namespace finemote::emulator
