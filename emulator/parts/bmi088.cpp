#include "emulator/parts/bmi088.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace finemote::emulator {
namespace {

// Accelerometer, data sheet 5.3; gyroscope, 5.5.
constexpr unsigned kAccelId = 0x00, kAccelData = 0x12, kAccelTime = 0x18, kAccelStatus = 0x1D, kAccelTemperature = 0x22,
                   kAccelConf = 0x40, kAccelRange = 0x41, kAccelInt1 = 0x53, kAccelInt2 = 0x54, kAccelMap = 0x58,
                   kAccelSelfTest = 0x6D, kAccelPowerConf = 0x7C, kAccelPower = 0x7D, kAccelReset = 0x7E;
constexpr unsigned kGyroId = 0x00, kGyroData = 0x02, kGyroStatus = 0x0A, kGyroRange = 0x0F, kGyroBandwidth = 0x10,
                   kGyroLowPower = 0x11, kGyroReset = 0x14, kGyroIntControl = 0x15, kGyroIntConf = 0x16,
                   kGyroIntMap = 0x18, kGyroSelfTest = 0x3C;
constexpr std::uint8_t kDataReady = 0x80;  // in both status registers and in GYRO_INT_CTRL
constexpr std::uint8_t kSoftReset = 0xB6;
constexpr std::uint32_t kFastestHz = 10'000'000;                               // 6.1, table 8
constexpr std::uint64_t kAccelStartNs = 1'000'000, kGyroStartNs = 30'000'000;  // 4.1, 4.2: after a reset
constexpr std::uint64_t kTimeStepNs = 39'063;                                  // 39.0625 us per step of the sensor time
constexpr Time kReadyFor = from_ns(280'000);                                   // 5.5.3: 280 to 400 us
constexpr std::uint8_t kPush = 0x0D, kPull = 0x09;                             // ACC_SELF_TEST, 5.3.19
constexpr double kDeflection[] = {0.75 * kGravity, 0.75 * kGravity,
                                  0.375 * kGravity};                                 // 4.6.1 asks for 1, 1, 0.5 g apart
constexpr std::uint8_t kStartTest = 0x01, kTestDone = 0x02, kRatesPlausible = 0x10;  // GYRO_SELF_TEST, 5.5.13
constexpr Time kGyroTest = from_ns(10'000'000);              // the data sheet does not say how long it takes
constexpr Time kTemperaturePeriod = from_ns(1'280'000'000);  // 5.3.7

void put(std::array<std::uint8_t, 128>& registers, unsigned at, double value) {
  const auto word = static_cast<std::uint16_t>(std::lround(std::clamp(value, -32768.0, 32767.0)));
  registers[at] = static_cast<std::uint8_t>(word);
  registers[at + 1] = static_cast<std::uint8_t>(word >> 8);
}

/// ACC_CONF: 12.5 Hz << (n - 5), n = 5..12.
Time accelerometer_period(std::uint8_t conf) {
  const unsigned n = std::clamp(conf & 0xFU, 5U, 12U);
  return from_ns(80'000'000ULL >> (n - 5));
}

/// GYRO_BANDWIDTH: 2000, 2000, 1000, 400, 200, 100, 200, 100 Hz.
Time gyroscope_period(std::uint8_t bandwidth) {
  constexpr std::uint64_t kHz[] = {2000, 2000, 1000, 400, 200, 100, 200, 100};
  return from_ns(1'000'000'000ULL / kHz[bandwidth & 7]);
}

}  // namespace

Bmi088::Bmi088(PartClock clock, std::function<Motion(Time)> motion, std::function<double(Time)> temperature)
    : clock_(std::move(clock)),
      motion_(std::move(motion)),
      temperature_(std::move(temperature)),
      outputs_{ReadyOutput(clock_, kReadyFor, [this] { return !silent; }),
               ReadyOutput(clock_, kReadyFor, [this] { return !silent; }),
               ReadyOutput(clock_, kReadyFor, [this] { return !silent; }),
               ReadyOutput(clock_, kReadyFor, [this] { return !silent; })} {
  for (const Output which : {Output::int1, Output::int2, Output::int3, Output::int4}) {
    output(which).on_level = [this, which](int level) {
      if (on_output) on_output(which, level);
    };
  }
  power_cycle();
}

void Bmi088::reset_accelerometer() {
  accel_ = {};
  accel_[kAccelId] = 0x1E;
  accel_[kAccelConf] = 0xA8;
  accel_[kAccelRange] = 0x01;
  accel_[kAccelPowerConf] = 0x03;
  accel_[kAccelTemperature] = 0x80;  // not valid yet
  accel_on_spi_ = converts_ = false;
  accel_sampled_ = accel_noticed_ = 0;
  accel_ready_ = now() + from_ns(kAccelStartNs);
  set_accelerometer_outputs();
}

void Bmi088::reset_gyroscope() {
  gyro_ = {};
  gyro_[kGyroId] = 0x0F;
  gyro_[kGyroIntConf] = 0x0F;
  gyro_sampled_ = 0;
  gyro_ready_ = now() + from_ns(kGyroStartNs);
  set_gyroscope_outputs();
}

void Bmi088::power_cycle() {
  reset_accelerometer();
  reset_gyroscope();
}

SpiPart Bmi088::accelerometer() {
  return SpiPart{[this](bool selected) { accelerometer_selected(selected); },
                 [this](WireByte out) { return accelerometer_byte(out); }, kFastestHz};
}

SpiPart Bmi088::gyroscope() {
  return SpiPart{[this](bool selected) { gyroscope_selected(selected); },
                 [this](WireByte out) { return gyroscope_byte(out); }, kFastestHz};
}

void Bmi088::accelerometer_selected(bool selected) {
  if (selected) {
    sample_acceleration();
  } else if (accel_exchange_.selected) {
    accel_on_spi_ = true;  // the first rising edge turns it from I2C to SPI: 6.1
  }
  end(accel_exchange_, Quantity::acceleration);
  accel_exchange_ = {selected};
}

/// A register of the accelerometer or the gyroscope; those of the values carry their sample.
WireByte Bmi088::value_byte(Exchange& exchange, Quantity quantity, unsigned address) {
  const bool rates = quantity == Quantity::rates;
  const unsigned first = rates ? kGyroData : kAccelData;
  const Time from = rates ? gyro_sampled_ : accel_sampled_;
  const std::uint8_t value = (rates ? gyro_ : accel_)[address];
  if (address < first || address >= first + 6 || from == 0 || !on_sample) return value;
  if (exchange.sample == Tag::none) exchange.sample = on_sample(quantity, from);
  return {value, exchange.sample};
}

void Bmi088::end(const Exchange& exchange, Quantity quantity) {
  if (exchange.sample != Tag::none && on_read) on_read(quantity, exchange.sample);
}

WireByte Bmi088::accelerometer_byte(std::uint8_t out) {
  Exchange& x = accel_exchange_;
  const unsigned index = x.count++;
  if (index == 0) {
    x.reading = (out & 0x80) != 0;
    x.address = out & 0x7F;
    return 0xFF;
  }
  if (!accel_on_spi_ || silent || now() < accel_ready_) return 0xFF;
  if (!x.reading) {
    if (index == 1) write_accelerometer(x.address, out);
    return 0xFF;
  }
  if (index == 1) return 0xA5;  // a byte without meaning comes first: 6.1.2
  const unsigned address = (x.address + index - 2) & 0x7F;
  const WireByte byte = value_byte(x, Quantity::acceleration, address);
  if (address == kAccelStatus) {  // cleared on read: 5.3.6
    accel_[kAccelStatus] = 0;
    accel_noticed_ = accel_sampled_;
    output(Output::int1).notice();
    output(Output::int2).notice();
  }
  return byte;
}

void Bmi088::write_accelerometer(std::uint8_t address, std::uint8_t value) {
  if (address == kAccelReset && value == kSoftReset) return reset_accelerometer();
  if (address < kAccelConf) return;
  accel_[address] = value;
  set_accelerometer_outputs();
  if (accelerometer_active() && !converts_) convert_temperature(now(), ++converting_);
  converts_ = accelerometer_active();
}

bool Bmi088::accelerometer_active() const { return accel_[kAccelPower] == 0x04 && accel_[kAccelPowerConf] == 0x00; }

/// INT1_IO_CONF and INT2_IO_CONF: level, open drain, output in bits 1 to 3; bits 2 and 6 of INT_MAP_DATA.
void Bmi088::set_accelerometer_outputs() {
  const auto settings = [this](unsigned conf, unsigned mapped) {
    ReadyOutput::Settings s;
    s.driven = (accel_[conf] & 8) != 0 && (accel_[kAccelMap] & mapped) != 0;
    s.period = accelerometer_active() ? accelerometer_period(accel_[kAccelConf]) : 0;
    s.active_high = (accel_[conf] & 2) != 0;
    s.open_drain = (accel_[conf] & 4) != 0;
    return s;
  };
  output(Output::int1).set(settings(kAccelInt1, 0x04));
  output(Output::int2).set(settings(kAccelInt2, 0x40));
}

void Bmi088::convert_temperature(Time at, std::uint64_t token) {
  if (token != converting_ || !accelerometer_active()) return;
  const auto word = static_cast<std::uint16_t>(std::lround((temperature_(at) - 23) * 8));  // 11 bits, 0.125 K
  accel_[kAccelTemperature] = static_cast<std::uint8_t>(word >> 3);
  accel_[kAccelTemperature + 1] = static_cast<std::uint8_t>(word << 5);
  const Time next = at + kTemperaturePeriod;
  clock_.at(next, [this, next, token] { convert_temperature(next, token); });
}

void Bmi088::sample_acceleration() {
  if (!accelerometer_active() || now() < accel_ready_) return;
  const Time period = accelerometer_period(accel_[kAccelConf]);
  accel_sampled_ = now() / period * period;
  const Motion motion = motion_(accel_sampled_);
  const double full = 3.0 * (1 << (accel_[kAccelRange] & 3)) * kGravity;
  const std::uint8_t test = accel_[kAccelSelfTest];
  const double pushed = test == kPush ? 1 : test == kPull ? -1 : 0;
  for (unsigned i = 0; i < 3; ++i)
    put(accel_, kAccelData + 2 * i, (motion.force[i] + pushed * kDeflection[i]) / full * 32768);
  const std::uint64_t steps = to_ns(now()) / kTimeStepNs;
  for (unsigned i = 0; i < 3; ++i) accel_[kAccelTime + i] = static_cast<std::uint8_t>(steps >> (8 * i));
  accel_[kAccelStatus] = accel_sampled_ != accel_noticed_ ? kDataReady : 0;
}

void Bmi088::gyroscope_selected(bool selected) {
  if (selected) sample_rates();
  end(gyro_exchange_, Quantity::rates);
  gyro_exchange_ = {selected};
}

WireByte Bmi088::gyroscope_byte(std::uint8_t out) {
  Exchange& x = gyro_exchange_;
  const unsigned index = x.count++;
  if (index == 0) {
    x.reading = (out & 0x80) != 0;
    x.address = out & 0x7F;
    return 0xFF;
  }
  if (silent || now() < gyro_ready_) return 0xFF;
  if (x.reading) return value_byte(x, Quantity::rates, (x.address + index - 1) & 0x7F);
  if (index == 1) write_gyroscope(x.address, out);
  return 0xFF;
}

void Bmi088::write_gyroscope(std::uint8_t address, std::uint8_t value) {
  if (address == kGyroReset && value == kSoftReset) return reset_gyroscope();
  if (address < kGyroRange) return;
  if (address == kGyroSelfTest) return test_gyroscope(value);
  gyro_[address] = address == kGyroBandwidth ? value | 0x80 : value;
  set_gyroscope_outputs();
}

/// It passes, after a while.
void Bmi088::test_gyroscope(std::uint8_t value) {
  if ((value & kStartTest) == 0) return;
  gyro_[kGyroSelfTest] = kRatesPlausible;
  clock_.at(now() + kGyroTest, [this, started = gyro_ready_] {
    if (started == gyro_ready_) gyro_[kGyroSelfTest] |= kTestDone;  // not reset meanwhile
  });
}

/// INT3_INT4_IO_CONF: level and open drain of INT3 in bits 0 and 1, of INT4 in 2 and 3; bits 0 and 7 of
/// INT3_INT4_IO_MAP.
void Bmi088::set_gyroscope_outputs() {
  const auto settings = [this](unsigned shift, unsigned mapped) {
    const bool samples = gyro_[kGyroLowPower] == 0 && (gyro_[kGyroIntControl] & kDataReady) != 0;
    ReadyOutput::Settings s;
    s.driven = (gyro_[kGyroIntMap] & mapped) != 0;
    s.period = samples ? gyroscope_period(gyro_[kGyroBandwidth]) : 0;
    s.active_high = (gyro_[kGyroIntConf] >> shift & 1) != 0;
    s.open_drain = (gyro_[kGyroIntConf] >> shift & 2) != 0;
    return s;
  };
  output(Output::int3).set(settings(0, 0x01));
  output(Output::int4).set(settings(2, 0x80));
}

void Bmi088::sample_rates() {
  if (gyro_[kGyroLowPower] != 0 || now() < gyro_ready_) return;
  const Time period = gyroscope_period(gyro_[kGyroBandwidth]);
  gyro_sampled_ = now() / period * period;
  const Motion motion = motion_(gyro_sampled_);
  const double full = 2000.0 / (1 << std::min(gyro_[kGyroRange] & 7, 4)) * std::numbers::pi / 180;
  for (unsigned i = 0; i < 3; ++i) put(gyro_, kGyroData + 2 * i, motion.rate[i] / full * 32768);
  const bool told = (gyro_[kGyroIntControl] & kDataReady) != 0 && now() - gyro_sampled_ < kReadyFor;
  gyro_[kGyroStatus] = told ? kDataReady : 0;
}

}  // namespace finemote::emulator
