// A part that sends a frame on a serial line at a fixed rate.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "emulator/chip/peripheral.hpp"
#include "emulator/chip/usart.hpp"

namespace finemote::emulator {

/// A frame that is due while the one before is still on its way is left out: the line is too slow for the rate.
class FrameSender {
 public:
  FrameSender(const FrameSender&) = delete;
  FrameSender& operator=(const FrameSender&) = delete;

  bool silent = false;          ///< sends nothing
  unsigned damaged_frames = 0;  ///< the next ones have a wrong sum
  /// Told when a frame begins that is good. @return what its bytes carry
  std::function<Tag(Time begin, Time end)> on_frame;
  [[nodiscard]] unsigned frames() const { return frames_; }

 protected:
  /// @param period  between the beginnings of two frames
  FrameSender(World& world, Usart& usart, const SerialFormat& format, Time period)
      : world_(world), usart_(usart), format_(format), period_(period) {}
  virtual ~FrameSender() = default;

  /// The first frame begins after `phase`.
  void begin(Time phase);

 private:
  /// A frame that begins now. Its last byte is one of its sum.
  virtual std::vector<std::uint8_t> make_frame(Time now) = 0;
  void send();

  World& world_;
  Usart& usart_;
  SerialFormat format_;
  Time period_;
  unsigned frames_ = 0;
};

}  // namespace finemote::emulator
