// SBUS: bytes to channels and flags, and the part model's frame of the same channels.
#include "finemote/devices/sbus.hpp"

#include <algorithm>

#include "emulator/parts/remote.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/line.hpp"

namespace finemote::evidence {
namespace {

/// What the driver took of a vector.
struct Reading {
  std::vector<Taken> frames;
  std::vector<double> channels;
  bool digital[2] = {}, failsafe = false, frame_lost = false;
};

Reading read(const Vector& vector) {
  Line<Sbus> line(100000, UartFormat::k8E2Inverted);
  Reading reading;
  line.run(
      vector, [](const Sbus& device) { return device.frames(); },
      [&](const Sbus& device, const Taken& frame) {
        reading.frames.push_back(frame);
        reading.channels.clear();
        for (unsigned n = 1; n <= 16; ++n) reading.channels.push_back(device.channel(n));
        for (const unsigned n : {17U, 18U}) reading.digital[n - 17] = device.digital(n);
        reading.failsafe = device.failsafe();
        reading.frame_lost = device.frame_lost();
      });
  return reading;
}

/// Pulse widths [us] that a flight controller makes of a channel.
std::vector<double> pulses(const std::vector<double>& channels, double scale, double rounding, double offset) {
  std::vector<double> widths;
  for (const double channel : channels) widths.push_back(std::floor(channel * scale + rounding) + offset);
  return widths;
}

/// Bursts that brought no frame, and how long after the frame before they began.
void put_slots(Findings& findings, const Vector& vector, const std::vector<Taken>& frames) {
  std::vector<double> offsets;
  for (std::size_t i = 1; i < vector.bursts.size(); ++i) {
    const auto brought = [&](std::size_t burst) {
      return std::any_of(frames.begin(), frames.end(), [&](const Taken& frame) { return frame.burst == burst; });
    };
    if (!brought(i) && brought(i - 1))
      offsets.push_back(static_cast<double>(vector.bursts[i].at - vector.bursts[i - 1].at) * 1e-9);
  }
  findings.put({"telemetry_slots"}, static_cast<double>(offsets.size()));
  if (offsets.empty()) return;
  // A source states limits within which all lie.
  const Tolerance within{0, 2e-6};
  findings.put({"slot_offset_ns_min"}, Dimension::number, {*std::min_element(offsets.begin(), offsets.end()) * 1e9},
               {0, within.absolute * 1e9});
  findings.put({"slot_offset_ns_max"}, Dimension::number, {*std::max_element(offsets.begin(), offsets.end()) * 1e9},
               {0, within.absolute * 1e9});
}

void put_frames(Findings& findings, const Vector& vector, const Reading& reading) {
  const std::vector<Taken>& frames = reading.frames;
  findings.put({"frames"}, static_cast<double>(frames.size()));
  findings.put({"accepted", "accepted_after_resync"}, frames.empty() ? 0 : 1);
  if (frames.empty()) return findings.refuse();
  findings.put({"skip"}, static_cast<double>(frames[0].first));
  std::vector<std::string> ends;
  for (const Taken& frame : frames) {
    const Bytes& burst = vector.bursts[frame.burst].bytes;
    const auto last = static_cast<std::size_t>(frame.first) + Sbus::kFrame - 1;
    ends.push_back(last < burst.size() ? hexadecimal({burst[last]}) : "?");
  }
  findings.put_text("end_bytes", ends);
  findings.put_text("end_byte", {ends.back()});
  if (frames.size() < 2) return;
  const double span = static_cast<double>(frames.back().begin - frames[0].begin) * 1e-9;
  findings.put({"frame_interval"}, Dimension::time, {span / static_cast<double>(frames.size() - 1)}, {1e-3, 0});
}

}  // namespace

Findings decode_sbus(const Vector& vector) {
  Findings findings;
  const Reading reading = read(vector);
  put_frames(findings, vector, reading);
  put_slots(findings, vector, reading.frames);
  if (reading.frames.empty()) return findings;
  findings.put({"channels_raw", "channels"}, reading.channels);
  findings.put({"channels_px4", "channels_px4_us"}, pulses(reading.channels, 0.625, 0.5, 874));
  findings.put({"channels_ardupilot", "channels_ardupilot_us"}, pulses(reading.channels, 0.625, 0, 875));
  findings.put({"ch17", "channel_17", "d1"}, reading.digital[0] ? 1 : 0);
  findings.put({"ch18", "channel_18", "d2"}, reading.digital[1] ? 1 : 0);
  findings.put({"failsafe"}, reading.failsafe ? 1 : 0);
  findings.put({"frame_lost", "lost_frame"}, reading.frame_lost ? 1 : 0);
  const int flags = (reading.digital[0] ? 1 : 0) | (reading.digital[1] ? 2 : 0) | (reading.frame_lost ? 4 : 0) |
                    (reading.failsafe ? 8 : 0);
  findings.put({"flags"}, flags);

  emulator::SbusChannels channels;
  std::transform(reading.channels.begin(), reading.channels.end(), channels.begin(),
                 [](double channel) { return static_cast<unsigned>(channel); });
  const Bytes frame = emulator::sbus_frame(channels, static_cast<std::uint8_t>(flags));
  const Bytes bytes = vector.bytes();
  const bool holds = std::search(bytes.begin(), bytes.end(), frame.begin(), frame.end() - 1) != bytes.end();
  findings.check("the part model's frame", holds);
  return findings;
}

}  // namespace finemote::evidence
