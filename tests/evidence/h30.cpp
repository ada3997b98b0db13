// H30: bytes to acceleration, rates and attitude, and the part model's frame of the same attitude.
#include "finemote/devices/h30_imu.hpp"

#include <algorithm>

#include "emulator/parts/h30.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/line.hpp"

namespace finemote::evidence {
namespace {

constexpr std::int64_t kBaud = 460800;
constexpr std::size_t kAround = 7;  ///< header and sums

/// The driver, mounted straight.
struct Straight : H30Imu {
  explicit Straight(Uart& uart) : H30Imu(nullptr, uart) {}
};

/// Numbers of the wire are whole millionths; single precision keeps some seven digits of them.
constexpr Tolerance kSteps{2e-7, 1e-6};

void put_state(Findings& findings, const ImuState& state) {
  const auto three = [](const float(&values)[3]) { return std::vector<double>(values, values + 3); };
  findings.put({"accel", "acceleration"}, Dimension::acceleration, three(state.acceleration), kSteps);
  findings.put({"rate", "rates", "gyro"}, Dimension::angular_speed, three(state.rate), kSteps);
  const double roll = state.roll, pitch = state.pitch, yaw = state.yaw;
  findings.put({"euler_pitch_roll_yaw"}, Dimension::angle, {pitch, roll, yaw}, kSteps);
  findings.put({"roll"}, Dimension::angle, {roll}, kSteps);
  findings.put({"pitch"}, Dimension::angle, {pitch}, kSteps);
  findings.put({"yaw"}, Dimension::angle, {yaw}, kSteps);
}

}  // namespace

Findings decode_h30(const Vector& vector) {
  Findings findings;
  Line<Straight> line(kBaud, UartFormat::k8N1);
  ImuState state;
  Taken last;
  std::size_t first = 0;
  line.run(
      vector, [](const Straight& device) { return device.frames(); },
      [&](const Straight& device, const Taken& frame) {
        state = device.state;
        if (last.begin == 0) first = static_cast<std::size_t>(frame.first);
        last = frame;
      });
  const std::uint32_t frames = line.device().frames();
  findings.put({"frames"}, frames);
  findings.put({"accepted", "accepted_after_resync"}, frames > 0 ? 1 : 0);
  findings.put({"bad_frames"}, line.device().bad_frames());
  if (frames == 0) {
    findings.refuse();
    return findings;
  }
  put_state(findings, state);
  for (const char* left_out : {"tid", "magnetic_normalised", "quaternion"})
    findings.put({left_out}, std::vector<double>{});
  findings.put({"magnetic_raw"}, Dimension::field, {});
  findings.put({"skip"}, static_cast<double>(first));
  // Where the frame begins, the driver has said; its length byte is the fifth.
  const Bytes& burst = vector.bursts[last.burst].bytes;
  const auto begin = burst.begin() + std::max<std::ptrdiff_t>(last.first, 0);
  const std::size_t payload = burst.end() - begin > 4 ? begin[4] : 0;
  findings.put({"payload_length"}, static_cast<double>(payload));
  findings.put({"frame_length"}, static_cast<double>(payload + kAround));
  const bool whole = burst.end() - begin >= static_cast<std::ptrdiff_t>(payload + kAround);
  const auto sums = begin + static_cast<std::ptrdiff_t>(payload + kAround - 2);
  findings.put_text("checksum", {whole ? hexadecimal({sums, sums + 2}) : "?"});
  return findings;
}

}  // namespace finemote::evidence
