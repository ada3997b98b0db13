// DR16: bytes to sticks, switches, mouse and keys, and the part model's frame of the same hands.
#include "finemote/devices/dr16.hpp"

#include <cmath>

#include "emulator/parts/remote.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/line.hpp"

namespace finemote::evidence {
namespace {

constexpr double kFull = 660;  ///< counts of a stick at its end

/// As the wire codes it.
int code_of(RemoteSwitch position) {
  switch (position) {
    case RemoteSwitch::kUp:
      return 1;
    case RemoteSwitch::kDown:
      return 2;
    case RemoteSwitch::kMiddle:
      return 3;
    case RemoteSwitch::kUnknown:
      break;
  }
  return 0;
}

void put_stick(Findings& findings, const std::string& name, double share) {
  const std::string unit = name + "_unit", raw = name + "_raw";
  findings.put({name.c_str()}, std::round(share * kFull));
  findings.put({unit.c_str()}, Dimension::number, {share}, {1e-5, 1e-7});
  findings.put({raw.c_str()}, std::round(share * kFull) + 1024);
}

void put_keys(Findings& findings, std::uint16_t keys) {
  constexpr const char* kKeys[] = {"key_w", "key_s", "key_a", "key_d", "key_shift", "key_ctrl", "key_q", "key_e",
                                   "key_r", "key_f", "key_g", "key_z", "key_x",     "key_c",    "key_v", "key_b"};
  findings.put({"keys", "key", "keyboard"}, keys);
  for (unsigned bit = 0; bit < 16; ++bit) findings.put({kKeys[bit]}, keys >> bit & 1);
}

Bytes modelled(const RemoteState& state) {
  emulator::Hands hands;
  hands.right_x = state.right_x;
  hands.right_y = state.right_y;
  hands.left_x = state.left_x;
  hands.left_y = state.left_y;
  hands.wheel = state.wheel;
  hands.left_switch = static_cast<emulator::Hands::Switch>(code_of(state.left_switch));
  hands.right_switch = static_cast<emulator::Hands::Switch>(code_of(state.right_switch));
  hands.keys = state.keys;
  for (unsigned i = 0; i < 3; ++i) hands.mouse[i] = state.mouse[i];
  hands.mouse_left = state.mouse_left;
  hands.mouse_right = state.mouse_right;
  return emulator::dbus_frame(hands);
}

}  // namespace

Findings decode_dr16(const Vector& vector) {
  Findings findings;
  Line<Dr16> line(100000, UartFormat::k8E1Inverted);
  RemoteState state;
  std::size_t frames = 0;
  Taken last;
  // A frame that counts moves the origin.
  line.run(
      vector, [](const Dr16& device) { return static_cast<std::uint32_t>(device.state.origin); },
      [&](const Dr16& device, const Taken& frame) {
        state = device.state;
        last = frame;
        ++frames;
      });
  findings.put({"frames"}, static_cast<double>(frames));
  findings.put({"accepted", "connected", "online"}, frames > 0 ? 1 : 0);
  if (frames == 0) {
    findings.refuse();
    return findings;
  }
  put_stick(findings, "ch0", state.right_x);
  put_stick(findings, "ch1", state.right_y);
  put_stick(findings, "ch2", state.left_x);
  put_stick(findings, "ch3", state.left_y);
  put_stick(findings, "wheel", state.wheel);
  findings.put({"left_switch"}, code_of(state.left_switch));
  findings.put({"right_switch"}, code_of(state.right_switch));
  findings.put({"mouse_x"}, state.mouse[0]);
  findings.put({"mouse_y"}, state.mouse[1]);
  findings.put({"mouse_z"}, state.mouse[2]);
  findings.put({"mouse_left"}, state.mouse_left ? 1 : 0);
  findings.put({"mouse_right"}, state.mouse_right ? 1 : 0);
  put_keys(findings, state.keys);

  const Bytes& burst = vector.bursts[last.burst].bytes;
  Bytes frame = burst.size() >= Dr16::kFrame ? Bytes(burst.end() - Dr16::kFrame, burst.end()) : Bytes{};
  Bytes model = modelled(state);
  if (state.wheel == 0 && frame.size() == Dr16::kFrame && frame[16] == 0 && frame[17] == 0) model[16] = model[17] = 0;
  if (!frame.empty()) findings.check("the part model's frame", model == frame);
  return findings;
}

}  // namespace finemote::evidence
