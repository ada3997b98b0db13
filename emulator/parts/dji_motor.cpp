#include "emulator/parts/dji_motor.hpp"

#include <cmath>
#include <numbers>

namespace finemote::emulator {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSteps = 8192;  // of the rotor's encoder
constexpr Time kPause = from_ns(8'000'000);

void put(CanFrame& frame, unsigned at, double value) {
  const auto word = static_cast<std::uint16_t>(std::lround(std::clamp(value, -32768.0, 32767.0)));
  frame.data[at] = static_cast<std::uint8_t>(word >> 8);
  frame.data[at + 1] = static_cast<std::uint8_t>(word);
}

}  // namespace

DjiMotor::DjiMotor(World& world, CanLine& line, const Figures& figures, const MotorShaft::Parameters& shaft)
    : world_(world), line_(line), figures_(figures), shaft_(shaft) {
  line_.attach(CanLine::Node{[this] { return waiting_; },
                             [this](const CanFrame& frame, CanOutcome outcome) { sent(frame, outcome); },
                             [this](const CanFrame& frame) { hear(frame); }});
  world_.after(figures_.phase, [this] { tick(); });
}

void DjiMotor::tick() {
  world_.after(figures_.period, [this] { tick(); });
  if (silent) return waiting_.reset();
  waiting_ = report(world_.now());
  line_.request();
}

void DjiMotor::sent(const CanFrame& frame, CanOutcome outcome) {
  if (outcome != CanOutcome::received) return;                     // tried again
  if (waiting_ && waiting_->tags == frame.tags) waiting_.reset();  // else a newer one waits by now
  if (on_report && frame.tags[0] != Tag::none) on_report(frame.tags[0]);
}

CanFrame DjiMotor::report(Time now) {
  CanFrame frame{figures_.feedback_id, 8, {}};
  const double turns = (shaft_.angle(now) * figures_.gear + figures_.zero) / kTurn;
  put(frame, 0, std::min(std::floor((turns - std::floor(turns)) * kSteps), kSteps - 1));
  put(frame, 2, shaft_.speed(now) * figures_.gear / kTurn * 60);
  put(frame, 4, shaft_.torque(now) / figures_.torque_per_ampere / figures_.full_current * figures_.full_word);
  frame.data[6] = static_cast<std::uint8_t>(figures_.temperature);
  if (damaged_reports != 0) {
    --damaged_reports;
    frame.data[0] = frame.data[1] = 0xFF;
  } else if (on_sample) {
    frame.tags.fill(on_sample());
  }
  return frame;
}

void DjiMotor::hear(const CanFrame& frame) {
  if (frame.id != figures_.command_id || frame.size != 8) return;
  const auto word = static_cast<std::int16_t>(frame.data[2 * figures_.word] << 8 | frame.data[2 * figures_.word + 1]);
  const int full = static_cast<int>(figures_.full_word);
  command_ = std::clamp<int>(word, -full, full);
  ++commands_;
  if (world_.now() - heard_ > kPause) {
    resumed_with_ = command_;
    ++pauses_;
  }
  heard_ = world_.now();
  shaft_.drive(world_.now(), current() * figures_.torque_per_ampere);
  if (on_command) on_command(word, newest(frame.tags[2 * figures_.word], frame.tags[2 * figures_.word + 1]));
}

}  // namespace finemote::emulator
