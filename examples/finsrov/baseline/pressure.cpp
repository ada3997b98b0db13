#include "pressure.hpp"

#include "i2c_master.hpp"

namespace baseline {

namespace {

using namespace finemote;

constexpr std::uint8_t kMux = 0x70, kSensor = 0x76;
// Commands, data sheet "Commands"; conversions at an oversampling of 1024.
constexpr std::uint8_t kReset = 0x1E, kReadAdc = 0x00, kPressure = 0x44, kTemperature = 0x54, kReadProm = 0xA0;
constexpr Duration kResetTime = 20 * kMillisecond, kPause = 3 * kMillisecond;
constexpr std::uint8_t kPressures = 15;
constexpr float kPascals = 10;  ///< of the 30 bar variant's unit

bool command(std::uint8_t byte) { return write_i2c(kSensor, &byte, 1); }

}  // namespace

bool PressureSensor::select() const {
  const auto byte = static_cast<std::uint8_t>(1U << channel_);
  return write_i2c(kMux, &byte, 1);
}

void PressureSensor::start() {
  select();
  command(kReset);
  wait_at_start(kResetTime);
  for (unsigned word = 0; word < 7; ++word) {
    std::uint8_t bytes[2]{};
    command(static_cast<std::uint8_t>(kReadProm + 2 * word));
    read_i2c(kSensor, bytes, 2);
    calibration_.c[word] = static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
  }
  begin(Kind::temperature);
  wait_at_start(kPause);
}

bool PressureSensor::begin(Kind kind) {
  running_ = kind;
  begun_ = now();
  return command(kind == Kind::pressure ? kPressure : kTemperature);
}

std::uint32_t PressureSensor::result() const {
  std::uint8_t bytes[3]{};
  if (!command(kReadAdc) || !read_i2c(kSensor, bytes, 3)) return 0;
  return std::uint32_t{bytes[0]} << 16 | std::uint32_t{bytes[1]} << 8 | bytes[2];
}

void PressureSensor::turn() {
  const bool selected = select();
  const std::uint32_t value = selected ? result() : 0;
  const Kind kind = running_;
  const Time begun = begun_;
  pressures_ = kind == Kind::temperature ? 0 : static_cast<std::uint8_t>(pressures_ + 1);
  begin(pressures_ < kPressures ? Kind::pressure : Kind::temperature);
  if (value == 0) {
    state.valid = false;
  } else if (kind == Kind::temperature) {
    temperature_ = value;
  } else {
    pressure_ = value;
    pressure_begun_ = begun;
    publish();
  }
}

void PressureSensor::set_pressure(std::uint32_t result) {
  pressure_ = result;
  pressure_begun_ = begun_;
}

void PressureSensor::compute() { publish(); }

void PressureSensor::publish() {
  const auto value = Ms5837::compensate(Ms5837::Variant::k30BA, calibration_, pressure_, temperature_);
  state.pressure = static_cast<float>(value.pressure) * kPascals;
  state.temperature = static_cast<float>(value.temperature) * 0.01F;
  state.origin = pressure_begun_;
  state.valid = true;
}

}  // namespace baseline
