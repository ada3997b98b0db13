#include "finemote/devices/bmi088.hpp"

#include "finemote/control/numbers.hpp"
#include "little_endian.hpp"

namespace finemote {

namespace {

// Registers: BMI088 data sheet, chapters 5.3 (accelerometer) and 5.5 (gyroscope).
constexpr std::uint8_t kRead = 0x80;
constexpr std::uint8_t kChipId = 0x00;
constexpr std::uint8_t kAccelData = 0x12;    ///< x, y, z, two bytes each; then the 24-bit sensor time from 0x18
constexpr std::uint8_t kTemperature = 0x22;  ///< TEMP_MSB, TEMP_LSB: 5.3.7
constexpr std::uint8_t kGyroData = 0x00;     ///< identity, a reserved byte, then x, y, z
constexpr std::uint8_t kAccelId = 0x1E, kGyroId = 0x0F;

// An accelerometer read puts one byte without meaning before the data (6.1.2).
constexpr unsigned kAccelDataAt = 2, kAccelTimeAt = 8, kGyroIdAt = 1, kGyroDataAt = 3;
constexpr unsigned kTemperatureAt = kAccelDataAt + kTemperature - kAccelData;
constexpr std::uint16_t kAccelShort = kAccelTimeAt + 3, kAccelLong = kTemperatureAt + 2;

/// One write of the bring-up, and how long the part needs after it.
struct Setting {
  bool gyro;
  std::uint8_t address, value;
  Duration wait;
};

constexpr Setting kSettings[] = {
    {false, kChipId | kRead, 0,
     1 * kMillisecond},                      // the first access with its select low turns the part from I2C to SPI
    {false, 0x7E, 0xB6, 50 * kMillisecond},  // ACC_SOFTRESET
    {true, 0x14, 0xB6, 50 * kMillisecond},   // GYRO_SOFTRESET
    {false, kChipId | kRead, 0, 1 * kMillisecond},  // and again after the reset
    {false, 0x7D, 0x04, 50 * kMillisecond},         // ACC_PWR_CTRL: on
    {false, 0x7C, 0x00, 5 * kMillisecond},          // ACC_PWR_CONF: active
    {false, 0x40, 0xAB, 1 * kMillisecond},          // ACC_CONF: 800 Hz, normal filter
    {false, 0x41, 0x01, 1 * kMillisecond},          // ACC_RANGE: 6 g
    {true, 0x0F, 0x00, 1 * kMillisecond},           // GYRO_RANGE: 2000 deg/s
    {true, 0x10, 0x82, 1 * kMillisecond},           // GYRO_BANDWIDTH: 1000 Hz, filter 116 Hz
    {true, 0x11, 0x00, 30 * kMillisecond},          // GYRO_LPM1: normal
    {true, 0x16, 0x00, 1 * kMillisecond},           // INT3_INT4_IO_CONF: INT3 push-pull, active low
    {true, 0x18, 0x01, 1 * kMillisecond},           // INT3_INT4_IO_MAP: data ready to INT3
    {true, 0x15, 0x80, 1 * kMillisecond},           // GYRO_INT_CTRL: data ready on
};
constexpr std::uint8_t kSettingCount = sizeof kSettings / sizeof kSettings[0];

constexpr float kAccelScale = 6 * 9.80665F / 32768;          ///< m/s^2
constexpr float kGyroScale = 2000 * 0.01745329252F / 32768;  ///< rad/s

/// What a read of the accelerometer brings is at most that old, `latency_ns` in the descriptor: a period of 800 Hz less
/// 5 %, 1.316 ms (data sheet 1.2, table 3), and its filter.
constexpr Duration kAccelAge = 2 * kMillisecond;

/// A step of the sensor time (data sheet 5.3.5).
constexpr Duration kChipTimeStep = 39'063;
/// How far the time between two reads may be from what passed there: the transfers wait for others.
constexpr Duration kChipTimeSlack = 2 * kMillisecond;

/// The sensor time goes on with that of the processor, give or take a quarter: it has not stood still, nor begun anew.
bool went_on(std::uint32_t chip_time, std::uint32_t last, Duration passed) {
  const std::uint32_t steps = (chip_time - last) & 0xFFFFFFU;
  const Duration off = static_cast<Duration>(steps) * kChipTimeStep - passed;
  return steps != 0 && (off < 0 ? -off : off) <= (passed >> 2U) + kChipTimeSlack;
}

}  // namespace

void Bmi088::update() {
  if (accel_->busy() || gyro_->busy()) return;
  if (now() < wait_until_) return;
  switch (step_) {
    case Step::kWait:
      entry_ = 0;
      step_ = Step::kSetUp;
      [[fallthrough]];
    case Step::kSetUp:
      return set_up();
    case Step::kCheck:
      return check();
    case Step::kRun:
      take_sample();
      if (step_ == Step::kRun) start_reads();
      return;
  }
}

// --------------------------------------------------------------------------------------------------------------
// bring-up

void Bmi088::set_up() {
  if (entry_ != 0 && !(kSettings[entry_ - 1].gyro ? gyro_ : accel_)->done()) return begin_again();
  if (entry_ < kSettingCount) {
    const Setting& setting = kSettings[entry_++];
    std::uint8_t* out = setting.gyro ? gyro_out_ : accel_out_;
    out[0] = setting.address;
    out[1] = setting.value;
    (setting.gyro ? gyro_ : accel_)->start(out, nullptr, setting.address == (kChipId | kRead) ? 3 : 2);
    wait_until_ = now() + setting.wait;
    return;
  }
  accel_out_[0] = gyro_out_[0] = kChipId | kRead;
  accel_->start(accel_out_, accel_in_, 3);
  gyro_->start(gyro_out_, gyro_in_, 2);
  step_ = Step::kCheck;
}

void Bmi088::check() {
  const bool there = accel_->done() && gyro_->done() && accel_in_[2] == kAccelId && gyro_in_[1] == kGyroId;
  if (!there) return begin_again();
  attitude_.reset();
  sampled_ = 0;
  failures_ = 0;
  started_ = false;
  step_ = Step::kRun;
  start_reads();
}

// --------------------------------------------------------------------------------------------------------------
// samples

void Bmi088::start_reads() {
  accel_out_[0] = kAccelData | kRead;
  gyro_out_[0] = kGyroData | kRead;
  if (ready_ != nullptr) edge_ = ready_->last();
  asked_ = now();
  accel_->start(accel_out_, accel_in_, heater_ != nullptr ? kAccelLong : kAccelShort);
  gyro_->start(gyro_out_, gyro_in_, sizeof gyro_in_);
  started_ = true;
}

void Bmi088::take_sample() {
  if (!started_) return;
  const Time ended = oldest(accel_->ended(), gyro_->ended());
  const bool good = accel_->done() && gyro_->done() && gyro_in_[kGyroIdAt] == kGyroId && takes_chip_time();
  const bool edges = ready_ == nullptr || (edge_.count != 0 && ended - edge_.at <= kMaxEdgeAge);
  if (!good || !edges) return fail();

  failures_ = 0;
  for (unsigned i = 0; i < 3; ++i) {
    state.acceleration[i] = static_cast<float>(int16_at(accel_in_ + kAccelDataAt + 2 * i)) * kAccelScale;
    state.rate[i] = static_cast<float>(int16_at(gyro_in_ + kGyroDataAt + 2 * i)) * kGyroScale;
  }
  turn(mount_, state.acceleration);
  turn(mount_, state.rate);
  const Time at = ready_ != nullptr ? oldest(ended, edge_.at) : ended;
  if (heater_ != nullptr) take_temperature(ended);
  const float dt = sampled_ == 0 ? 0 : seconds(at - sampled_);
  sampled_ = at;
  attitude_.step({config_.kp, config_.ki}, state.rate, state.acceleration, dt);
  state.roll = attitude_.roll();
  state.pitch = attitude_.pitch();
  state.yaw = attitude_.yaw();
  state.origin = ready_ != nullptr ? oldest(asked_ - kAccelAge, edge_.at) : asked_ - kAccelAge;
  state.valid = attitude_.aligned();
}

/// Keeps the time of a read that was answered; false where the part has not measured since the one before.
bool Bmi088::takes_chip_time() {
  const std::uint32_t last = chip_time_;
  const Duration passed = asked_ - chip_asked_;
  chip_time_ = uint24_at(accel_in_ + kAccelTimeAt);
  chip_asked_ = asked_;
  return sampled_ == 0 ? chip_time_ != last : went_on(chip_time_, last, passed);
}

// --------------------------------------------------------------------------------------------------------------
// heater

void Bmi088::take_temperature(Time at) {
  // Eleven bits, two's complement, 0.125 K each from 23 degrees on: 5.3.7.
  const auto bits = static_cast<std::int16_t>(accel_in_[kTemperatureAt] << 8 | accel_in_[kTemperatureAt + 1]);
  temperature_ = static_cast<float>(bits >> 5) * 0.125F + 23;
  warmed_ = at;
}

void Bmi088::handle() {
  if (heater_ == nullptr) return;
  const Time at = now();
  const bool known = warmed_ != 0 && at - warmed_ <= kMaxTemperatureAge;
  if (!known || temperature_ < kColdest || temperature_ > kHottest) {
    warmth_.reset();
    return safe();
  }
  const PidGains gains{config_.heater_kp, config_.heater_ki, 0, config_.heater_limit};
  const float dt = regulated_ == 0 ? 0 : seconds(at - regulated_);
  regulated_ = at;
  heat_ = clamp(warmth_.step(gains, config_.temperature - temperature_, 0, dt), 0, config_.heater_limit);
  heater_->set_share(heat_);
}

void Bmi088::safe() {
  heat_ = 0;
  if (heater_ != nullptr) heater_->set(0);
}

// --------------------------------------------------------------------------------------------------------------
// failures

void Bmi088::fail() {
  state.valid = false;
  if (++failures_ >= kMaxFailures) begin_again();
}

void Bmi088::begin_again() {
  state.valid = false;
  step_ = Step::kWait;
  wait_until_ = now() + 50 * kMillisecond;
}

}  // namespace finemote
