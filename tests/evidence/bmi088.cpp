// BMI088: registers to acceleration, rates and temperature, its set-up, and the part model both ways.
#include "finemote/devices/bmi088.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "emulator/parts/bmi088.hpp"
#include "finemote/bench/bench.hpp"
#include "tests/evidence/decoders.hpp"

namespace finemote::evidence {
namespace {

constexpr std::uint8_t kAccelId = 0x1E, kGyroId = 0x0F;
constexpr std::uint8_t kAccelData = 0x12, kTemperature = 0x22, kGyroData = 0x02;
constexpr double kGravity = 9.80665, kDegree = std::numbers::pi / 180;
/// The driver's ranges.
constexpr double kAccelRange = 6, kGyroRange = 2000;
/// Sources divide by 32767, 32768 or a rounded number of steps, and take 9.8 or 9.80665 for gravity.
constexpr Tolerance kScale{1e-3, 1e-9};

/// One of the two chips: registers that hold what a vector says, and everything written to them.
struct Chip : host::SpiPart {
  Chip(std::uint8_t id, std::size_t dummies) : dummies(dummies) { registers[0] = id; }
  Bytes exchange(const Bytes& bytes) override {
    Bytes out(bytes.size(), 0xFF);
    const std::uint8_t address = bytes[0] & 0x7F;
    asked.push_back(bytes[0]);
    if ((bytes[0] & 0x80) == 0) {
      writes.push_back({now(), bytes});
      return out;
    }
    const auto time = static_cast<std::uint32_t>(now() / 39063);  // the accelerometer's own clock
    for (int i = 0; i < 3 && dummies != 0; ++i) registers[0x18 + i] = static_cast<std::uint8_t>(time >> 8 * i);
    for (std::size_t i = 1 + dummies; i < out.size(); ++i) out[i] = registers[(address + i - 1 - dummies) & 0x7F];
    return out;
  }
  void hold(std::size_t from, const Bytes& values) {
    for (std::size_t i = 0; i < values.size(); ++i) registers[(from + i) & 0x7F] = values[i];
  }
  std::array<std::uint8_t, 128> registers{};
  std::size_t dummies;
  std::vector<std::pair<Time, Bytes>> writes;
  Bytes asked;
};

/// The driver with its heater, which makes it read the temperature, on the two chips.
struct Drive {
  Chip accelerometer{kAccelId, 1}, gyroscope{kGyroId, 0};
  ImuState state;
  double temperature = 0;

  void run() {
    bench::reset();
    host::spi1.connect(0, accelerometer);
    host::spi1.connect(1, gyroscope);
    SpiSlot* table[2] = {};
    SpiBus bus{ports::spi1, 10000000, table};
    SpiSlot accel_slot{bus, 0, 1}, gyro_slot{bus, 1, 1};
    table[0] = &accel_slot;
    table[1] = &gyro_slot;
    PwmBus heater{ports::imu_heater, 1'000'000};
    PwmChannel channel{heater, 0};
    Bmi088 imu{{}, nullptr, accel_slot, gyro_slot, &channel};
    bus.start();
    heater.start();
    const auto update_for = [&](int ms) {
      for (; ms != 0; --ms) {
        host::advance(kMillisecond);
        imu.update();
      }
    };
    const auto held = accelerometer.registers;
    accelerometer.hold(0x12,
                       {0, 0, 0, 0, 0x55, 0x15});  // level, 1 g of 6: nothing is valid before gravity has been seen
    update_for(500);
    accelerometer.registers = held;
    update_for(100);
    state = imu.state;
    temperature = imu.temperature();
  }
};

enum class Quantity { acceleration, rates, temperature };

bool has(const Json& expected, const char* begin) {
  for (const auto& [field, value] : expected.items()) {
    if (field.rfind(begin, 0) == 0) return true;
  }
  return false;
}

/// What bare bytes of a register hold, as the fields say.
Quantity quantity_of(const Vector& vector) {
  const Json& expected = vector.expected;
  if (has(expected, "rate") || has(expected, "gyro") || has(expected, "range_dps")) return Quantity::rates;
  return has(expected, "temp") ? Quantity::temperature : Quantity::acceleration;
}

/// Where they begin: a read of the gyroscope may begin with its identity and the reserved byte.
std::size_t address_of(const Vector& vector) {
  switch (quantity_of(vector)) {
    case Quantity::rates:
      return vector.bytes().size() == 8 ? 0 : kGyroData;
    case Quantity::temperature:
      return kTemperature;
    case Quantity::acceleration:
      break;
  }
  return kAccelData;
}

std::vector<Setting> written_to(const Chip& chip) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < chip.writes.size(); ++i) {
    const bool last = i + 1 == chip.writes.size();
    settings.push_back({chip.writes[i].second.at(0), chip.writes[i].second.at(1),
                        last ? kSecond : chip.writes[i + 1].first - chip.writes[i].first});
  }
  return settings;
}

bool sets_gyroscope(const Json& writes) {
  for (const Setting& setting : settings_of(writes)) {
    if (setting.address == 0x14 || setting.address == 0x0F) return true;
  }
  return false;
}

/// Ranges the part was in when the source read it.
struct Ranges {
  double accelerometer = kAccelRange, gyroscope = kGyroRange;
};

/// The range of a field of the vector, or the one at which the source's largest value is what the counts say; the
/// driver's where there is neither.
double range_of(const Json& expected, const char* field, std::initializer_list<const char*> values, double unit,
                const std::vector<double>& counts, std::initializer_list<double> ranges, double usual) {
  if (expected.contains(field)) return expected.at(field);
  for (const char* name : values) {
    if (!expected.contains(name)) continue;
    const auto source = expected.at(name).get<std::vector<double>>();
    for (std::size_t i = 0; i < counts.size() && i < source.size(); ++i) {
      if (counts[i] == 0) continue;
      const double fits = source[i] * unit / counts[i] * 32768;
      return *std::min_element(ranges.begin(), ranges.end(),
                               [&](double a, double b) { return std::abs(a - fits) < std::abs(b - fits); });
    }
  }
  return usual;
}

Ranges ranges_of(const Json& expected, const std::vector<double>& accel_counts,
                 const std::vector<double>& gyro_counts) {
  return {range_of(expected, "range_g", {"accel_m_s2"}, 1 / kGravity, accel_counts, {3, 6, 12, 24}, kAccelRange),
          range_of(expected, "range_dps", {"rate_rad_s", "gyro_rad_s"}, 1 / kDegree, gyro_counts,
                   {125, 250, 500, 1000, 2000}, kGyroRange)};
}

/// The ranges a register can set.
void put_ranges(Findings& findings, const Ranges& ranges) {
  for (const double range : {3, 6, 12, 24}) {
    if (range == ranges.accelerometer) findings.put({"range_g"}, range);
  }
  for (const double range : {125, 250, 500, 1000, 2000}) {
    if (range == ranges.gyroscope) findings.put({"range_dps"}, range);
  }
}

Ranges put_vector(Findings& findings, const Vector& vector, const Drive& drive) {
  const double accel_step = kAccelRange * kGravity / 32768, gyro_step = kGyroRange * kDegree / 32768;
  std::vector<double> acceleration, rates, accel_counts, gyro_counts;
  for (unsigned i = 0; i < 3; ++i) {
    accel_counts.push_back(std::round(drive.state.acceleration[i] / accel_step));
    gyro_counts.push_back(std::round(drive.state.rate[i] / gyro_step));
  }
  const Ranges ranges = ranges_of(vector.expected, accel_counts, gyro_counts);
  for (unsigned i = 0; i < 3; ++i) {
    acceleration.push_back(drive.state.acceleration[i] * ranges.accelerometer / kAccelRange);
    rates.push_back(drive.state.rate[i] * ranges.gyroscope / kGyroRange);
  }
  findings.put({"accel", "acceleration", "acc"}, Dimension::acceleration, acceleration, kScale);
  findings.put({"rate", "rates", "gyro", "angular_rate"}, Dimension::angular_speed, rates, kScale);
  findings.put({"counts", "raw"}, quantity_of(vector) == Quantity::rates ? gyro_counts : accel_counts);
  findings.put({"accel_counts"}, accel_counts);
  findings.put({"gyro_counts", "rate_counts"}, gyro_counts);
  findings.put({"temperature", "temp"}, Dimension::temperature, {drive.temperature});
  // How many steps a unit has: the driver's at its range, the range of the vector instead.
  findings.put({"lsb_per_g"}, Dimension::number, {32768 / ranges.accelerometer}, kScale);
  findings.put({"lsb_per_dps", "lsb_per_deg_s"}, Dimension::number, {32768 / ranges.gyroscope}, kScale);
  put_ranges(findings, ranges);
  return ranges;
}

// ------------------------------------------------------------------------------------------------------------ the
// model

class Model {
 public:
  Model(const Findings& findings, const Drive& drive, const Ranges& ranges) {
    const auto acceleration = findings.find("accel").finding->values, rates = findings.find("rate").finding->values;
    motion_.force = {acceleration[0], acceleration[1], acceleration[2]};
    motion_.rate = {rates[0], rates[1], rates[2]};
    celsius_ = drive.temperature;
    time_ = emulator::from_ns(40'000'000);
    exchange(accelerometer_, {0x80, 0, 0});
    exchange(accelerometer_, {0x7C, 0x00});
    exchange(accelerometer_, {0x7D, 0x04});
    exchange(accelerometer_, {0x41, static_cast<std::uint8_t>(std::lround(std::log2(ranges.accelerometer / 3)))});
    exchange(gyroscope_, {0x0F, static_cast<std::uint8_t>(std::lround(std::log2(2000 / ranges.gyroscope)))});
    time_ += emulator::from_ns(100'000'000);
  }
  /// `size` registers from `address` on, without what comes before them.
  Bytes read(bool gyroscope, std::size_t address, std::size_t size) {
    const std::size_t before = gyroscope ? 1 : 2;
    Bytes out(before + size);
    out[0] = static_cast<std::uint8_t>(address | 0x80);
    const Bytes answer = exchange(gyroscope ? gyroscope_ : accelerometer_, out);
    return {answer.begin() + static_cast<std::ptrdiff_t>(before), answer.end()};
  }

 private:
  static Bytes exchange(emulator::SpiPart& chip, const Bytes& bytes) {
    Bytes answer;
    chip.select(true);
    for (const std::uint8_t byte : bytes) answer.push_back(chip.exchange(byte));
    chip.select(false);
    return answer;
  }

  emulator::Time time_ = 0;
  emulator::Motion motion_;
  double celsius_ = 25;
  emulator::Bmi088 part_{{[this] { return time_; }, [](emulator::Time, emulator::EventQueue::Action) {}},
                         [this](emulator::Time) { return motion_; },
                         [this](emulator::Time) { return celsius_; }};
  emulator::SpiPart accelerometer_ = part_.accelerometer(), gyroscope_ = part_.gyroscope();
};

bool is_gyroscope(const Exchange& exchange) { return exchange.select.rfind("gyr", 0) == 0; }

/// Whether a later exchange reads the same: the first read of an accelerometer only turns it to SPI.
bool is_read_again(const std::vector<Exchange>& exchanges, std::size_t index) {
  return std::any_of(exchanges.begin() + static_cast<std::ptrdiff_t>(index) + 1, exchanges.end(),
                     [&](const Exchange& it) {
                       return it.select == exchanges[index].select && it.written == exchanges[index].written;
                     });
}

/// The part model, moved as the driver found, holds the bytes of the vector.
void check_model(Findings& findings, const Vector& vector, const Drive& drive, const Ranges& ranges) {
  Model model(findings, drive, ranges);
  const Bytes bytes = vector.bytes();
  if (!bytes.empty()) {
    const std::size_t address = address_of(vector);
    Bytes answer = model.read(quantity_of(vector) == Quantity::rates, address, bytes.size());
    if (address == 0) answer[1] = bytes[1];  // reserved
    findings.check("the part model's registers", answer == bytes);
  }
  for (std::size_t i = 0; i < vector.exchanges.size(); ++i) {
    const Exchange& asked = vector.exchanges[i];
    if (asked.read.empty() || asked.written.empty() || is_read_again(vector.exchanges, i)) continue;
    const std::size_t before = is_gyroscope(asked) ? 0 : 1;
    const Bytes values(asked.read.begin() + static_cast<std::ptrdiff_t>(before), asked.read.end());
    findings.check("the part model's answer to " + hexadecimal(asked.written),
                   model.read(is_gyroscope(asked), asked.written[0] & 0x7FU, values.size()) == values);
  }
}

/// What the vector's exchanges read goes into the registers; the first byte of the accelerometer means nothing.
void hold(Drive& drive, const Vector& vector) {
  const Bytes bytes = vector.bytes();
  const bool rates = !bytes.empty() && quantity_of(vector) == Quantity::rates;
  if (!bytes.empty()) (rates ? drive.gyroscope : drive.accelerometer).hold(address_of(vector), bytes);
  for (const Exchange& exchange : vector.exchanges) {
    Chip& chip = is_gyroscope(exchange) ? drive.gyroscope : drive.accelerometer;
    if (exchange.read.size() <= chip.dummies) continue;
    chip.hold(exchange.written.at(0) & 0x7FU,
              {exchange.read.begin() + static_cast<std::ptrdiff_t>(chip.dummies), exchange.read.end()});
  }
}

}  // namespace

Findings decode_bmi088(const Vector& vector) {
  Findings findings;
  Drive drive;
  hold(drive, vector);
  drive.run();
  findings.put({"accepted"}, drive.state.valid ? 1 : 0);
  const bool gyroscope = vector.expected.contains("writes") && sets_gyroscope(vector.expected.at("writes"));
  findings.writes = written_to(gyroscope ? drive.gyroscope : drive.accelerometer);
  findings.put({"accel_id", "accel_chip_id"}, drive.accelerometer.registers[0]);
  findings.put({"gyro_id", "gyro_chip_id"}, drive.gyroscope.registers[0]);
  if (!drive.state.valid) {
    findings.refuse();
    return findings;
  }
  const Ranges ranges = put_vector(findings, vector, drive);
  if (!vector.exchanges.empty()) {  // what the driver puts on the wire for it
    const Exchange& last = vector.exchanges.back();
    const Chip& chip = is_gyroscope(last) ? drive.gyroscope : drive.accelerometer;
    const bool asked =
        !last.written.empty() && std::find(chip.asked.begin(), chip.asked.end(), last.written[0]) != chip.asked.end();
    findings.put({"register_on_wire"}, asked ? last.written[0] : 0);
    findings.put({"length"}, static_cast<double>(last.read.size()));
    findings.put({"chip_id"}, chip.registers[0]);
  }
  check_model(findings, vector, drive, ranges);
  return findings;
}

}  // namespace finemote::evidence
