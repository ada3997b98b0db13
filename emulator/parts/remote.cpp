#include "emulator/parts/remote.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::emulator {
namespace {

/// Puts the 11 bits of a channel at a bit position, least significant first.
void put_channel(std::uint8_t* bytes, unsigned at, unsigned value) {
  for (unsigned bit = 0; bit < 11; ++bit) {
    if ((value >> bit & 1) != 0) bytes[(at + bit) / 8] |= static_cast<std::uint8_t>(1U << (at + bit) % 8);
  }
}

unsigned dbus_channel(double stick) {
  return static_cast<unsigned>(std::lround(1024 + 660 * std::clamp(stick, -1.0, 1.0)));
}

/// 172..992..1811, as transmitters send -100 %..100 %.
unsigned sbus_channel(double stick) {
  return static_cast<unsigned>(std::lround(992 + 819.5 * std::clamp(stick, -1.0, 1.0)));
}

double sbus_switch(Hands::Switch position) { return position == Hands::kUp ? -1 : position == Hands::kDown ? 1 : 0; }

}  // namespace

std::vector<std::uint8_t> dbus_frame(const Hands& hands) {
  std::vector<std::uint8_t> frame(18, 0);
  put_channel(frame.data(), 0, dbus_channel(hands.right_x));
  put_channel(frame.data(), 11, dbus_channel(hands.right_y));
  put_channel(frame.data(), 22, dbus_channel(hands.left_x));
  put_channel(frame.data(), 33, dbus_channel(hands.left_y));
  frame[5] |= static_cast<std::uint8_t>(hands.left_switch << 6 | hands.right_switch << 4);
  for (unsigned i = 0; i < 3; ++i) {
    const auto counts = static_cast<std::uint16_t>(hands.mouse[i]);
    frame[6 + 2 * i] = static_cast<std::uint8_t>(counts);
    frame[7 + 2 * i] = static_cast<std::uint8_t>(counts >> 8);
  }
  frame[12] = hands.mouse_left ? 1 : 0;
  frame[13] = hands.mouse_right ? 1 : 0;
  frame[14] = static_cast<std::uint8_t>(hands.keys);
  frame[15] = static_cast<std::uint8_t>(hands.keys >> 8);
  put_channel(frame.data(), 128, dbus_channel(hands.wheel));
  return frame;
}

std::vector<std::uint8_t> sbus_frame(const SbusChannels& channels, std::uint8_t flags) {
  std::vector<std::uint8_t> frame(25, 0);
  frame[0] = 0x0F;
  for (unsigned i = 0; i < channels.size(); ++i) put_channel(&frame[1], 11 * i, channels[i]);
  frame[23] = flags;
  return frame;
}

std::vector<std::uint8_t> sbus_frame(const Hands& hands) {
  SbusChannels channels;
  channels.fill(992);
  channels[0] = sbus_channel(hands.right_x);
  channels[1] = sbus_channel(hands.right_y);
  channels[2] = sbus_channel(hands.left_y);
  channels[3] = sbus_channel(hands.left_x);
  channels[4] = sbus_channel(sbus_switch(hands.left_switch));
  channels[5] = sbus_channel(sbus_switch(hands.right_switch));
  channels[6] = sbus_channel(hands.wheel);
  return sbus_frame(channels, hands.failsafe ? 0x0C : 0);  // frame lost, failsafe
}

RemoteReceiver::RemoteReceiver(World& world, Usart& usart, const SerialFormat& format, Encode encode, Time period,
                               Time phase)
    : world_(world), usart_(usart), format_(format), encode_(encode), period_(period) {
  world_.after(phase, [this] { send(); });
}

void RemoteReceiver::send() {
  world_.after(period_, [this] { send(); });
  if (silent) return;
  std::vector<std::uint8_t> frame = encode_(hands);
  Tag sample = Tag::none;
  if (damaged_frames != 0) {
    --damaged_frames;
    frame.pop_back();
  } else if (on_frame) {
    sample = on_frame(world_.now(), world_.now() + frame.size() * format_.byte_time());
  }
  usart_.send_in(frame, format_, sample);
}

}  // namespace finemote::emulator
