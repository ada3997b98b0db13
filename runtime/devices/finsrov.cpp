#include "finemote/devices/finsrov.hpp"

#include <cmath>

#include "finemote/control/numbers.hpp"
#include "text.hpp"

namespace finemote {

namespace {

constexpr float kGravity = 9.80665F;
constexpr float kDegree = 0.01745329252F;  ///< rad
constexpr float kUpDownStep = 0.01F;       ///< m
constexpr float kHoldDepth = 0.30F;        ///< least target depth when switched on [m]
constexpr float kDeepest = 300;            ///< m, what 30 bar allow
constexpr float kShortestStep = 0.002F;  ///< s: samples of two sensors that lie closer together are one depth, not two
constexpr float kRateFilter = 0.3F;      ///< share of a new sample in the vertical speed
constexpr Duration kReportEvery = 100 * kMillisecond;

// TES pulses, as the host program means them: 1500 us neutral, 400 us to full effort.
constexpr float kTestNeutral = 1500, kTestEffort = 1.0F / 400;

using Line = Text<64>;

Line line_of(const ImuState& attitude, float depth) {
  Line line;
  line.add("RPY:").add_hundredths(attitude.roll / kDegree);
  line.add(",").add_hundredths(attitude.pitch / kDegree);
  line.add(",").add_hundredths(attitude.yaw / kDegree);
  line.add(",").add_hundredths(100 * depth).add("\r\n");
  return line;
}

Line line_of(Ports<Pressure> sensors) {
  Line line;
  line.add("VA:");
  for (unsigned i = 0; i < sensors.size(); ++i) {
    if (i != 0) line.add(",");
    line.add_number(static_cast<std::int32_t>(sensors[i].state.pressure));
  }
  line.add("\r\n");
  return line;
}

}  // namespace

void FinsRov::update() {
  const Time at = now();
  const bool is_asked = host_ != nullptr && take_orders(at);
  take_inputs(at);
  if (is_asked || (reporting_ && at - reported_ >= kReportEvery)) report(is_asked, at);
}

void FinsRov::handle() {
  const Time at = now();
  if (at - ordered_ > config_.host_max_age) {
    surge_ = sway_ = turn_ = 0;
    if (mode_ == Mode::kTest) mode_ = Mode::kOff;
  }
  switch (mode_) {
    case Mode::kOff:
      command_nothing();
      break;
    case Mode::kTest:
      command_test(at);
      break;
    case Mode::kHold:
      command_thrusters(control(at));
      break;
  }
}

// ---------------------------------------------------------------------------------------------------------------
// inputs

void FinsRov::take_inputs(Time at) {
  float sum = 0;
  std::int32_t fresh = 0;
  Time origin = at;
  for (unsigned i = 0; i < depth_.size(); ++i) {
    const PressureState& sensor = depth_[i].state;
    if (!is_fresh(sensor, at, config_.input_max_age)) continue;
    sum += sensor.pressure - surface_[i];
    origin = oldest(origin, sensor.origin);
    ++fresh;
  }
  const bool has_depth = fresh >= config_.depth_quorum && fresh > 0;
  if (has_depth && !depth_follows_) depth_loop_.reset();  // it has summed errors that nobody turned against
  depth_follows_ = has_depth;
  if (has_depth) {
    take_depth(sum / (static_cast<float>(fresh) * config_.density * kGravity), origin);
  }
  take_attitude();
  state.origin = oldest(depth_at_, attitude_.origin);
  state.valid = depth_known_ && attitude_.valid;
}

/// A sensor that comes back may count its yaw from elsewhere, and the loops have summed errors that nobody turned
/// against.
void FinsRov::take_attitude() {
  const bool is_back = imu_.state.valid && !attitude_follows_;
  attitude_follows_ = imu_.state.valid;
  if (!imu_.state.valid) return;
  attitude_ = imu_.state;
  if (!is_back) return;
  target_yaw_ = attitude_.yaw;
  roll_loop_.reset();
  pitch_loop_.reset();
  yaw_loop_.reset();
}

/// A depth [m] and when it was measured. The same samples again change nothing, and no rate comes of depths that differ
/// because a sensor has come or gone.
void FinsRov::take_depth(float depth, Time origin) {
  const float dt = seconds(origin - depth_at_);
  const bool follows = depth_known_ && dt <= StepTime::kLongest;
  if (follows && dt >= kShortestStep) depth_rate_ += kRateFilter * ((depth - depth_now_) / dt - depth_rate_);
  if (!follows) depth_rate_ = 0;
  depth_known_ = true;
  depth_now_ = depth;
  depth_at_ = origin;
}

// ---------------------------------------------------------------------------------------------------------------
// orders

/// Whether one of them asks for the pressures.
bool FinsRov::take_orders(Time at) {
  if (!orders_.receive(*host_)) return false;
  FinsRovOrder order;
  bool is_asked = false;
  for (unsigned left = FinsRovHost::kMostOrders; left != 0 && orders_.next(order); --left) {
    obey(order, at);
    is_asked = is_asked || order.verb == FinsRovOrder::Verb::kValues;
  }
  return is_asked;
}

void FinsRov::obey(const FinsRovOrder& order, Time at) {
  using Verb = FinsRovOrder::Verb;
  switch (order.verb) {
    case Verb::kOn:
      return hold();
    case Verb::kOff:
      mode_ = Mode::kOff;
      return;
    case Verb::kUp:
      return aim(target_depth_ - kUpDownStep);
    case Verb::kDown:
      return aim(target_depth_ + kUpDownStep);
    case Verb::kDepth:
      return aim(static_cast<float>(order.value[0]) * 0.001F);
    case Verb::kForward:
      return move(config_.cruise, 0, 0);
    case Verb::kBack:
      return move(-config_.cruise, 0, 0);
    case Verb::kLeft:
      return move(0, config_.cruise, 0);
    case Verb::kRight:
      return move(0, -config_.cruise, 0);
    case Verb::kTurnLeft:
      return move(0, 0, config_.turn);
    case Verb::kTurnRight:
      return move(0, 0, -config_.turn);
    case Verb::kStop:
      return move(0, 0, 0);
    case Verb::kHeadingOn:
      heading_on_ = true;
      target_yaw_ = attitude_.yaw;
      yaw_loop_.reset();
      return;
    case Verb::kHeadingOff:
      heading_on_ = false;
      return;
    case Verb::kHeading:
      target_yaw_ = wrap_angle(static_cast<float>(order.value[0]) * kDegree);
      return;
    case Verb::kReportOn:
      reporting_ = true;
      return;
    case Verb::kReportOff:
      reporting_ = false;
      return;
    case Verb::kTest:
      return test(order);
    case Verb::kCalibrate:
      return set_surface(at);
    case Verb::kValues:
    case Verb::kServos:
    case Verb::kNothing:
      return;
  }
}

void FinsRov::hold() {
  if (mode_ != Mode::kHold) {
    depth_loop_.reset();
    roll_loop_.reset();
    pitch_loop_.reset();
    yaw_loop_.reset();
    surge_ = sway_ = turn_ = 0;
    target_yaw_ = attitude_.yaw;
  }
  const float here = depth_now_ - kUpDownStep;
  aim(here > kHoldDepth ? here : kHoldDepth);
  mode_ = Mode::kHold;
}

void FinsRov::aim(float depth) { target_depth_ = clamp(depth, 0, kDeepest); }

void FinsRov::move(float surge, float sway, float turn) {
  surge_ = surge;
  sway_ = sway;
  turn_ = turn;
  ordered_ = orders_.origin();
}

void FinsRov::test(const FinsRovOrder& order) {
  if (mode_ == Mode::kHold) return;
  for (unsigned i = 0; i < kThrusters; ++i) {
    test_[i] = clamp((static_cast<float>(order.value[i]) - kTestNeutral) * kTestEffort, -1, 1);
  }
  ordered_ = orders_.origin();
  mode_ = Mode::kTest;
}

void FinsRov::set_surface(Time at) {
  for (unsigned i = 0; i < kSensors && i < depth_.size(); ++i) {
    const PressureState& sensor = depth_[i].state;
    if (is_fresh(sensor, at, config_.input_max_age)) surface_[i] = sensor.pressure;
  }
}

// --------------------------------------------------------------------------------------------------------------
// control

FinsRov::Wrench FinsRov::control(Time at) {
  const float dt = step_.next(at);
  const Config& c = config_;
  const ImuState& imu = attitude_;

  const float sink = depth_loop_.step({c.depth_kp, c.depth_ki, c.depth_kd, c.depth_limit}, target_depth_ - depth_now_,
                                      depth_rate_, dt);
  const float roll = roll_loop_.step({c.roll_kp, c.roll_ki, 0, c.roll_rate_limit}, -imu.roll, 0, dt);
  const float pitch = pitch_loop_.step({c.pitch_kp, c.pitch_ki, 0, c.pitch_rate_limit}, -imu.pitch, 0, dt);
  float yaw = 0;
  if (heading_on_) {
    if (turn_ != 0) target_yaw_ = imu.yaw;  // the operator turns it: hold what comes out
    yaw = yaw_loop_.step({c.yaw_kp, c.yaw_ki, 0, c.yaw_rate_limit}, wrap_angle(target_yaw_ - imu.yaw), 0, dt);
  }

  Wrench wrench;
  wrench.value[0] = surge_;
  wrench.value[1] = sway_;
  wrench.value[2] = c.heave_trim - sink;
  wrench.value[3] = clamp(c.roll_rate_kp * (roll - imu.rate[0]), -c.roll_limit, c.roll_limit);
  wrench.value[4] = clamp(c.pitch_rate_kp * (pitch - imu.rate[1]), -c.pitch_limit, c.pitch_limit);
  wrench.value[5] = turn_ + clamp(c.yaw_rate_kp * (yaw - imu.rate[2]), -c.yaw_limit, c.yaw_limit);
  return wrench;
}

void FinsRov::command_thrusters(const Wrench& wrench) {
  for (unsigned n = 0; n < thrusters_.size() && n < kThrusters; ++n) {
    float effort = 0;
    for (unsigned k = 0; k < 6; ++k) effort += allocation_[n][k] * wrench.value[k];
    ThrusterCommand& command = thrusters_[n].command;
    command.effort = clamp(effort, -1, 1);
    command.origin = state.origin;
    command.valid = state.valid && std::isfinite(effort);
  }
}

void FinsRov::command_test(Time at) {
  for (unsigned n = 0; n < thrusters_.size() && n < kThrusters; ++n) {
    ThrusterCommand& command = thrusters_[n].command;
    command.effort = test_[n];
    command.origin = at;  // the order stands for host_max_age
    command.valid = true;
  }
}

void FinsRov::command_nothing() {
  for (const Port<Thruster>& thruster : thrusters_) {
    thruster.command.effort = 0;
    thruster.command.valid = false;
  }
}

// ---------------------------------------------------------------------------------------------------------------
// report

/// One line at most: the host's takes one block at a time. Attitude and depth come with the next update where it asks
/// for the pressures.
void FinsRov::report(bool is_asked, Time at) {
  const Line line = is_asked ? line_of(depth_) : line_of(attitude_, depth_now_);
  if (host_->write(line.bytes(), line.size()) && !is_asked) reported_ = at;
}

}  // namespace finemote
