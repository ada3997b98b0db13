#include "emulator/parts/computer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace finemote::emulator {
namespace {

constexpr std::uint8_t kCommands = 0x20;  // kind 2, block 0

template <class Word>
void put(std::vector<std::uint8_t>& bytes, Word word) {
  for (unsigned i = 0; i < sizeof word; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> 8 * i));
}

template <class Integer>
void put_rounded(std::vector<std::uint8_t>& bytes, double value) {
  using Limits = std::numeric_limits<Integer>;
  const double least = static_cast<double>(Limits::min()), most = static_cast<double>(Limits::max());
  put(bytes,
      static_cast<std::make_unsigned_t<Integer>>(static_cast<Integer>(std::clamp(std::round(value), least, most))));
}

void put_value(std::vector<std::uint8_t>& bytes, char letter, const SentCommands& commands) {
  switch (letter) {
    case 'v':
      return bytes.push_back(commands.valid ? 1 : 0);
    case '?':
      return bytes.push_back(commands.value != 0 ? 1 : 0);
    case 'B':
      return put_rounded<std::uint8_t>(bytes, commands.value);
    case 'h':
      return put_rounded<std::int16_t>(bytes, commands.value);
    case 'H':
      return put_rounded<std::uint16_t>(bytes, commands.value);
    case 'i':
      return put_rounded<std::int32_t>(bytes, commands.value);
    case 'I':
      return put_rounded<std::uint32_t>(bytes, commands.value);
    case 'q':
      return put_rounded<std::int64_t>(bytes, commands.value);
    default:
      return put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(commands.value)));
  }
}

/// CRC-16, polynomial 0x1021 from 0xFFFF, highest bit first.
std::uint16_t sum_of(const std::vector<std::uint8_t>& bytes, std::size_t from) {
  std::uint16_t sum = 0xFFFF;
  for (std::size_t i = from; i < bytes.size(); ++i) {
    sum = static_cast<std::uint16_t>(sum ^ bytes[i] << 8);
    for (unsigned bit = 0; bit < 8; ++bit)
      sum = static_cast<std::uint16_t>((sum & 0x8000) != 0 ? sum << 1 ^ 0x1021 : sum << 1);
  }
  return sum;
}

}  // namespace

std::vector<std::uint8_t> command_frame(std::uint32_t layout, std::uint8_t sequence, const std::string& values,
                                        const SentCommands& commands) {
  std::vector<std::uint8_t> payload;
  for (const char letter : values) put_value(payload, letter, commands);
  std::vector<std::uint8_t> frame{0xA5, 0x5A, kCommands, static_cast<std::uint8_t>(payload.size())};
  put(frame, layout);
  frame.push_back(sequence);
  frame.insert(frame.end(), payload.begin(), payload.end());
  put(frame, sum_of(frame, 2));
  return frame;
}

Computer::Computer(World& world, Usart& usart, const SerialFormat& format, Link link, Time period, Time phase)
    : FrameSender(world, usart, format, period), link_(std::move(link)) {
  if (!link_.values.empty()) begin(phase);
}

std::vector<std::uint8_t> Computer::make_frame(Time /*now*/) {
  return command_frame(link_.layout, sequence_++, link_.values, commands);
}

}  // namespace finemote::emulator
