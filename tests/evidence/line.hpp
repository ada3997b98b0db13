// A device on a serial line that brings a vector's bursts at their times.
#pragma once

#include <cmath>

#include "finemote/bench/bench.hpp"
#include "finemote/uart.hpp"
#include "tests/evidence/vectors.hpp"

namespace finemote::evidence {

/// A frame that the device took, as the bytes of the vector.
struct Taken {
  std::size_t burst = 0;     ///< in which it begins
  Time begin = 0;            ///< of the frame, from the vector's start
  std::ptrdiff_t first = 0;  ///< index of its first byte in the burst
};

/// @tparam Device  made of a Uart; its update() is called every millisecond
template <class Device>
class Line {
 public:
  Line(std::int64_t baud, UartFormat format) : uart_(ports::usart3, baud, ring_, format) {
    bench::reset();
    uart_.start();
  }

  /// Gives it the bursts. `look` is called with the device and each frame it takes.
  /// @param count  of frames so far, whatever the device does with them
  template <class Count, class Look>
  void run(const Vector& vector, Count&& count, Look&& look) {
    Time end = kBegin;
    for (const Burst& burst : vector.bursts) {
      host::usart3.feed(kBegin + burst.at, burst.bytes);
      end = kBegin + burst.at + byte_time() * static_cast<Duration>(burst.bytes.size());
    }
    std::uint32_t before = count(device_);
    while (now() < end + 20 * kMillisecond) {
      host::advance(kMillisecond);
      device_.update();
      if (count(device_) != before) look(device_, taken(vector));
      before = count(device_);
    }
  }

  Device& device() { return device_; }
  [[nodiscard]] Duration byte_time() const { return uart_.wire_time(1); }

 private:
  static constexpr Time kBegin = kMillisecond;

  Taken taken(const Vector& vector) const {
    Taken frame;
    frame.begin = device_.state.origin - kBegin;
    for (std::size_t i = 0; i < vector.bursts.size(); ++i) {
      if (vector.bursts[i].at <= frame.begin + byte_time() / 2) frame.burst = i;
    }
    frame.first = std::lround(static_cast<double>(frame.begin - vector.bursts[frame.burst].at) /
                              static_cast<double>(byte_time()));
    return frame;
  }

  std::uint8_t ring_[256];
  Uart uart_;
  Device device_{uart_};
};

}  // namespace finemote::evidence
