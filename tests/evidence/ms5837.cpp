// MS5837: memory and conversions to pressure and temperature, and what the part model answers to the same commands.
#include "finemote/devices/ms5837.hpp"

#include <algorithm>

#include "emulator/parts/ms5837.hpp"
#include "finemote/bench/bench.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/i2c_replay.hpp"

namespace finemote::evidence {
namespace {

constexpr std::uint8_t kAddress = emulator::Ms5837::kAddress;
constexpr std::uint8_t kReadProm = 0xA0, kConvert = 0x40, kConvertTemperature = 0x50, kConvertEnd = 0x60;

/// What a vector says of the part: its memory, and what its converter gives.
struct Content {
  emulator::Ms5837::Prom words{};
  std::optional<std::uint32_t> pressure, temperature;
  bool has_words = false, has_checksum = false;
};

std::uint32_t number_in(const Bytes& bytes) {
  std::uint32_t number = 0;
  for (const std::uint8_t byte : bytes) number = number << 8 | byte;
  return number;
}

Content content_of(const Vector& vector) {
  Content content;
  std::uint8_t converting = 0;
  for (const Exchange& exchange : vector.exchanges) {
    for (std::size_t i = 0; i < exchange.coefficients.size() && i < 6; ++i)
      content.words[i + 1] = exchange.coefficients[i];
    for (std::size_t i = 0; i < exchange.words.size() && i < 7; ++i) content.words[i] = exchange.words[i];
    content.has_words = content.has_words || !exchange.coefficients.empty() || !exchange.words.empty();
    content.has_checksum = content.has_checksum || !exchange.words.empty();
    if (exchange.pressure) content.pressure = exchange.pressure;
    if (exchange.temperature) content.temperature = exchange.temperature;
    if (exchange.written.empty()) continue;
    const std::uint8_t command = exchange.written[0];
    if (command >= kConvert && command < kConvertEnd) converting = command;
    if (command >= kReadProm && command < kReadProm + 14 && exchange.read.size() == 2) {
      content.words[(command - kReadProm) / 2U] = static_cast<std::uint16_t>(number_in(exchange.read));
      content.has_words = content.has_checksum = true;
    }
    if (command == 0 && exchange.read.size() == 3) {
      (converting >= kConvertTemperature ? content.temperature : content.pressure) = number_in(exchange.read);
    }
  }
  return content;
}

/// The part as the driver sees it.
struct Scripted : host::I2cPart {
  explicit Scripted(const Content& content) : content(content) {}
  bool write(const Bytes& bytes) override {
    command = bytes.at(0);
    if (command >= kConvert && command < kConvertEnd) converting = command;
    return true;
  }
  bool read(std::size_t size, Bytes& bytes) override {
    std::uint32_t value = command == 0 ? converted() : content.words[(command - kReadProm) / 2 % 7];
    for (std::size_t i = size; i > 0; --i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * (i - 1)));
    return true;
  }
  [[nodiscard]] std::uint32_t converted() const {
    return converting >= kConvertTemperature ? content.temperature.value_or(0) : content.pressure.value_or(0);
  }
  Content content;
  std::uint8_t command = 0, converting = 0;
};

/// The driver's reading of the part, and whether it took its memory.
struct Reading {
  PressureState state;
  Ms5837::Calibration calibration;
  bool took_memory = false;
};

Reading drive(const Content& content, Ms5837::Variant variant) {
  bench::reset();
  Scripted part(content);
  host::i2c2.connect(kAddress, part);
  I2cSlot* table[1] = {};
  I2cBus bus{ports::i2c2, 400000, table};
  I2cSlot slot{bus, kAddress, {}, 1};
  table[0] = &slot;
  Ms5837 sensor{{variant, 4096}, slot};
  bus.start();
  Reading reading;
  for (int i = 0; i < 60; ++i) {
    host::advance(5 * kMillisecond);
    sensor.update();
    if (part.converting != 0 && !reading.took_memory) {
      reading.took_memory = true;
      reading.calibration = sensor.calibration();
    }
    if (sensor.state.valid) reading.state = sensor.state;
  }
  return reading;
}

void put_calibration(Findings& findings, const Ms5837::Calibration& calibration) {
  findings.put({"crc4_stored", "crc_stored"}, calibration.c[0] >> 12);
  findings.put({"crc4_computed", "crc4", "crc_computed"}, Ms5837::crc4(calibration));
  findings.put({"crc4_ok", "crc_ok"}, calibration.c[0] >> 12 == Ms5837::crc4(calibration) ? 1 : 0);
  for (unsigned i = 1; i < 7; ++i) findings.put({("c" + std::to_string(i)).c_str()}, calibration.c[i]);
  findings.put({"prom"}, std::vector<double>(calibration.c + 1, calibration.c + 7));
}

void put_pressure(Findings& findings, const Reading& reading, const Content& content, Ms5837::Variant variant) {
  const bool wide = variant == Ms5837::Variant::k30BA;
  const double pascal = wide ? 10 : 1;  // of a step
  const std::uint32_t d1 = content.pressure.value_or(0), d2 = content.temperature.value_or(0);
  const Ms5837::FirstOrder first = Ms5837::first_order(variant, reading.calibration, d2);
  findings.put({"d1", "d1_raw"}, d1);
  findings.put({"d2", "d2_raw"}, d2);
  findings.put({"dT", "dt"}, static_cast<double>(first.dt));
  // Whole steps, rounded down; some sources round them, some do not.
  const Tolerance steps{0, 0.0101}, pressure_steps{0, 1.01 * pascal};
  findings.put({"temperature_first_order"}, Dimension::temperature, {static_cast<double>(first.temperature) * 0.01},
               steps);
  findings.put({"temperature", "temperature_second_order", "temp"}, Dimension::temperature, {reading.state.temperature},
               steps);
  findings.put({"pressure_first_order"}, Dimension::pressure,
               {Ms5837::pressure(variant, d1, first.offset, first.sensitivity) * pascal}, pressure_steps);
  findings.put({"pressure", "pressure_second_order"}, Dimension::pressure, {reading.state.pressure}, pressure_steps);
  findings.put({"temp_raw"}, static_cast<double>(first.temperature));
  findings.put({"off", "offset"}, static_cast<double>(first.offset));
  findings.put({"sens", "sensitivity"}, static_cast<double>(first.sensitivity));
}

/// The part model with the vector's memory answers every read of it; conversions are its own.
void replay(Findings& findings, const Vector& vector, const Content& content, Ms5837::Variant variant) {
  namespace em = emulator;
  em::Time time = em::from_ns(100'000'000);
  const auto kind = variant == Ms5837::Variant::k30BA ? em::Ms5837::Variant::k30BA : em::Ms5837::Variant::k02BA;
  em::Ms5837 part(
      kind, [&] { return time; }, [](em::Time) { return 101'325.0; });
  part.calibrate(content.words);
  for (const Exchange& asked : vector.exchanges) {
    if (asked.written.empty()) continue;
    Exchange at_address = asked;
    at_address.address = kAddress;
    const std::optional<Bytes> answer = exchange(part, at_address);
    time += em::from_ns(20'000'000);
    const bool is_result = asked.written[0] == 0;
    findings.check("the part model's answer to " + hexadecimal(asked.written),
                   answer && answer->size() == asked.read.size() && (is_result || *answer == asked.read));
  }
}

/// Conversions without a memory are decoded with the data sheet's.
void complete(Content& content) {
  constexpr emulator::Ms5837::Prom kSheet = {0, 34982, 36352, 20328, 22354, 26646, 26146};
  if (!content.has_words) content.words = kSheet;
  if (content.has_checksum) return;
  Ms5837::Calibration calibration;
  std::copy(content.words.begin(), content.words.end(), calibration.c);
  content.words[0] = static_cast<std::uint16_t>(content.words[0] | Ms5837::crc4(calibration) << 12);
}

}  // namespace

Findings decode_ms5837(const Vector& vector) {
  Findings findings;
  const bool small = vector.expected.value("variant", std::string("30BA")) == "02BA";
  const Ms5837::Variant variant = small ? Ms5837::Variant::k02BA : Ms5837::Variant::k30BA;
  findings.put_text("variant", {small ? "02BA" : "30BA"});
  Content content = content_of(vector);
  complete(content);
  const Reading reading = drive(content, variant);
  findings.put({"accepted", "valid"}, reading.took_memory ? 1 : 0);
  if (!reading.took_memory) {
    Ms5837::Calibration calibration;
    std::copy(content.words.begin(), content.words.end(), calibration.c);
    put_calibration(findings, calibration);
    // A source may say so by its two checksums alone.
    if (calibration.c[0] >> 12 == Ms5837::crc4(calibration)) findings.refuse();
    return findings;
  }
  put_calibration(findings, reading.calibration);
  if (content.temperature || content.pressure) put_pressure(findings, reading, content, variant);
  replay(findings, vector, content, variant);
  return findings;
}

}  // namespace finemote::evidence
