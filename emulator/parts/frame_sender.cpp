#include "emulator/parts/frame_sender.hpp"

namespace finemote::emulator {

void FrameSender::begin(Time phase) {
  world_.after(phase, [this] { send(); });
}

void FrameSender::send() {
  world_.after(period_, [this] { send(); });
  if (silent || usart_.is_receiving()) return;
  std::vector<std::uint8_t> frame = make_frame(world_.now());
  Tag sample = Tag::none;
  if (damaged_frames != 0) {
    --damaged_frames;
    frame.back() ^= 0xFF;
  } else if (on_frame) {
    sample = on_frame(world_.now(), world_.now() + frame.size() * format_.byte_time());
  }
  ++frames_;
  usart_.send_in(frame, format_, sample);
}

}  // namespace finemote::emulator
