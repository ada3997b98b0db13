#include "runtime/boards/host/ports/h30_part.hpp"

#include <cmath>

#include "finemote/host.hpp"

namespace finemote::host {

namespace {

constexpr double kDegree = 57.29577951308232;

void append(std::vector<std::uint8_t>& frame, std::uint8_t type, std::initializer_list<double> values) {
  frame.push_back(type);
  frame.push_back(static_cast<std::uint8_t>(4 * values.size()));
  for (const double value : values) {
    const auto wire = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 1e6)));
    for (int shift = 0; shift < 32; shift += 8) frame.push_back(static_cast<std::uint8_t>(wire >> shift));
  }
}

}  // namespace

std::vector<std::uint8_t> h30_frame(const ImuState& state, std::uint16_t number) {
  std::vector<std::uint8_t> frame{0x59, 0x53, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
                                  0};
  append(frame, 0x10, {state.acceleration[0], state.acceleration[1], state.acceleration[2]});
  append(frame, 0x20, {state.rate[0] * kDegree, state.rate[1] * kDegree, state.rate[2] * kDegree});
  append(frame, 0x40, {state.pitch * kDegree, state.roll * kDegree, state.yaw * kDegree});
  append(frame, 0x41, {1, 0, 0, 0});
  frame[4] = static_cast<std::uint8_t>(frame.size() - 5);
  std::uint8_t sum1 = 0, sum2 = 0;
  for (std::size_t i = 2; i < frame.size(); ++i) {
    sum1 = static_cast<std::uint8_t>(sum1 + frame[i]);
    sum2 = static_cast<std::uint8_t>(sum2 + sum1);
  }
  frame.push_back(sum1);
  frame.push_back(sum2);
  return frame;
}

H30Part::H30Part(UartHardware& line, Time begin, Duration interval) : line_(line), interval_(interval) { send(begin); }

void H30Part::send(Time at) {
  interrupt_at(at, [this, at] {
    if (!silent) {
      std::vector<std::uint8_t> frame = h30_frame(state, number++);
      if (noisy) frame[7 + number % 50] ^= 0x40;
      line_.feed(at, frame);
    }
    send(at + interval_);
  });
}

}  // namespace finemote::host
