#include "finemote/devices/ms5837.hpp"

namespace finemote {

namespace {

// Commands, data sheets "Commands".
constexpr std::uint8_t kResetCommand = 0x1E;
constexpr std::uint8_t kReadAdc = 0x00;
constexpr std::uint8_t kConvertPressure = 0x40;
constexpr std::uint8_t kConvertTemperature = 0x50;
constexpr std::uint8_t kReadProm = 0xA0;

constexpr unsigned kPromWords = 7;
constexpr Duration kResetTime = 20 * kMillisecond;

// Operating ranges: -20..85 degrees Celsius; 0..2 bar in 0.01 mbar, 0..30 bar in 0.1 mbar.
constexpr std::int32_t kColdest = -2000, kHottest = 8500;
constexpr float kLargestJump = 50000;  ///< Pa between two values: 5 m of water in some 10 ms
constexpr std::int32_t kHighest02 = 200000, kHighest30 = 300000;

constexpr std::int64_t power(int exponent) { return std::int64_t{1} << exponent; }
/// x / 2^exponent rounded down, as the data sheets' worked examples are: an arithmetic shift with every compiler we
/// use.
constexpr std::int64_t over_power(std::int64_t x, int exponent) { return x >> exponent; }
static_assert(over_power(-3, 1) == -2, "needs an arithmetic shift");
constexpr std::int64_t square(std::int64_t x) { return x * x; }

/// Second-order corrections, to be subtracted.
struct Correction {
  std::int64_t temperature = 0, offset = 0, sensitivity = 0;
};

Correction correction_02(std::int64_t dt, std::int64_t temperature) {
  if (temperature >= 2000) return {};
  const std::int64_t cold = square(temperature - 2000);
  return {over_power(11 * square(dt), 35), over_power(31 * cold, 3), over_power(63 * cold, 5)};
}

Correction correction_30(std::int64_t dt, std::int64_t temperature) {
  const std::int64_t away = square(temperature - 2000);
  if (temperature >= 2000) return {over_power(2 * square(dt), 37), over_power(away, 4), 0};
  Correction c{over_power(3 * square(dt), 33), over_power(3 * away, 1), over_power(5 * away, 3)};
  if (temperature < -1500) {
    const std::int64_t very_cold = square(temperature + 1500);
    c.offset += 7 * very_cold;
    c.sensitivity += 4 * very_cold;
  }
  return c;
}

}  // namespace

// Data sheets "Pressure and temperature calculation". The largest product, d1 * sensitivity, is below 2^58.
Ms5837::FirstOrder Ms5837::first_order(Variant variant, const Calibration& calibration, std::uint32_t d2) {
  const auto& c = calibration.c;
  const bool wide = variant == Variant::k30BA;
  const std::int64_t dt = std::int64_t{d2} - c[5] * power(8);
  return {dt, 2000 + over_power(dt * c[6], 23),
          wide ? c[2] * power(16) + over_power(c[4] * dt, 7) : c[2] * power(17) + over_power(c[4] * dt, 6),
          wide ? c[1] * power(15) + over_power(c[3] * dt, 8) : c[1] * power(16) + over_power(c[3] * dt, 7)};
}

std::int32_t Ms5837::pressure(Variant variant, std::uint32_t d1, std::int64_t offset, std::int64_t sensitivity) {
  const std::int64_t scaled = over_power(d1 * sensitivity, 21);
  return static_cast<std::int32_t>(over_power(scaled - offset, variant == Variant::k30BA ? 13 : 15));
}

Ms5837::Compensated Ms5837::compensate(Variant variant, const Calibration& calibration, std::uint32_t d1,
                                       std::uint32_t d2) {
  const FirstOrder first = first_order(variant, calibration, d2);
  const Correction second = variant == Variant::k30BA ? correction_30(first.dt, first.temperature)
                                                      : correction_02(first.dt, first.temperature);
  return {static_cast<std::int32_t>(first.temperature - second.temperature),
          pressure(variant, d1, first.offset - second.offset, first.sensitivity - second.sensitivity)};
}

// Polynomial 0x3000 over the 16 bytes of eight words, the eighth being 0 (application note AN520).
std::uint8_t Ms5837::crc4(const Calibration& calibration) {
  unsigned remainder = 0;
  for (unsigned i = 0; i < 16; ++i) {
    const unsigned word = i / 2 == 0 ? calibration.c[0] & 0x0FFFU : i / 2 < kPromWords ? calibration.c[i / 2] : 0U;
    remainder ^= i % 2 == 0 ? word >> 8 : word & 0xFFU;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder & 0x8000U) != 0 ? (remainder << 1) ^ 0x3000U : remainder << 1;
    }
    remainder &= 0xFFFFU;
  }
  return static_cast<std::uint8_t>(remainder >> 12);
}

void Ms5837::update() {
  if (slot_->busy()) return;
  if (started_) {
    started_ = false;
    take_result();
  }
  begin_step();
}

// --------------------------------------------------------------------------------------------------------------
// results

void Ms5837::take_result() {
  if (!slot_->done()) {
    state.valid = false;
    if (step_ == Step::kConvert) step_ = Step::kFirst;  // whether the next conversion was commanded is unknown
    if (slot_->unreachable()) {
      known_ = false;
      step_ = Step::kReset;
    }
    return;
  }
  switch (step_) {
    case Step::kReset:
      ready_ = slot_->ended() + kResetTime;
      step_ = Step::kResetting;
      break;
    case Step::kResetting:
      break;
    case Step::kProm:
      take_prom_word();
      break;
    case Step::kFirst:
      conversion_begun(Kind::kTemperature);
      d2_ = 0;
      step_ = Step::kConvert;
      break;
    case Step::kConvert:
      take_conversion();
      break;
  }
}

void Ms5837::take_prom_word() {
  calibration_.c[word_] = static_cast<std::uint16_t>(read_[0] << 8 | read_[1]);
  if (++word_ < kPromWords) return;
  bool complete = calibration_.c[0] >> 12 == crc4(calibration_);
  for (unsigned i = 1; i < kPromWords; ++i) complete = complete && calibration_.c[i] != 0;
  step_ = complete ? Step::kFirst : Step::kReset;
}

void Ms5837::take_conversion() {
  const std::uint32_t value = std::uint32_t{read_[0]} << 16 | std::uint32_t{read_[1]} << 8 | read_[2];
  const Kind kind = running_;
  const Time begun = conversion_asked_;
  conversion_begun(next_);
  if (value == 0) return bad_value();  // read before the conversion had ended, or the part was reset
  if (kind == Kind::kTemperature) {
    d2_ = value;
    return;
  }
  d1_ = value;
  d1_asked_ = begun;
  if (d2_ != 0) publish();
}

void Ms5837::conversion_begun(Kind kind) {
  running_ = kind;
  conversion_asked_ = transfer_begun_;
  ready_ = slot_->ended() + conversion_;
}

void Ms5837::publish() {
  const Compensated value = compensate(variant_, calibration_, d1_, d2_);
  const bool wide = variant_ == Variant::k30BA;
  const float pressure = static_cast<float>(value.pressure) * (wide ? 10.0F : 1.0F);  // 0.1 mbar = 10 Pa
  const float jump = pressure - state.pressure;
  const bool continuous = !known_ || (jump <= kLargestJump && jump >= -kLargestJump);
  const bool plausible = continuous && value.temperature >= kColdest && value.temperature <= kHottest &&
                         value.pressure > 0 && value.pressure <= (wide ? kHighest30 : kHighest02);
  if (!plausible) return bad_value();
  bad_values_ = 0;
  known_ = true;
  state.origin = d1_asked_;
  state.valid = true;
  state.pressure = pressure;
  state.temperature = static_cast<float>(value.temperature) * 0.01F;
}

void Ms5837::bad_value() {
  state.valid = false;
  if (++bad_values_ < kBadValues) return;
  bad_values_ = 0;
  known_ = false;
  step_ = Step::kReset;
}

// ----------------------------------------------------------------------------------------------------------------
// steps

std::uint8_t Ms5837::command(Kind kind) const {
  return static_cast<std::uint8_t>((kind == Kind::kPressure ? kConvertPressure : kConvertTemperature) + step_size_);
}

void Ms5837::begin_step() {
  if (step_ == Step::kResetting && now() >= ready_) {
    word_ = 0;
    step_ = Step::kProm;
  }
  switch (step_) {
    case Step::kReset:
      write_[0] = kResetCommand;
      started_ = slot_->start(write_, 1);
      break;
    case Step::kResetting:
      break;
    case Step::kProm:
      write_[0] = static_cast<std::uint8_t>(kReadProm + 2 * word_);
      started_ = slot_->start(write_, 1, read_, 2);
      break;
    case Step::kFirst:
      write_[0] = command(Kind::kTemperature);
      pressures_ = 0;
      transfer_begun_ = now();
      started_ = slot_->start(write_, 1);
      break;
    case Step::kConvert:
      begin_convert();
      break;
  }
}

void Ms5837::begin_convert() {
  if (now() < ready_) return;
  next_ = pressures_ + 1 < kTemperatureEvery ? Kind::kPressure : Kind::kTemperature;
  pressures_ = next_ == Kind::kPressure ? static_cast<std::uint8_t>(pressures_ + 1) : std::uint8_t{0};
  write_[0] = kReadAdc;
  write_[1] = command(next_);
  transfer_begun_ = now();
  started_ = slot_->start(write_, 1, read_, 3, write_ + 1, 1);
}

}  // namespace finemote
