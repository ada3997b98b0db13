// IST8310: registers to a magnetic field, its set-up, and what the part model answers to a poll.
#include "finemote/devices/ist8310.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "emulator/parts/ist8310.hpp"
#include "finemote/bench/bench.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/i2c_replay.hpp"

namespace finemote::evidence {
namespace {

constexpr std::uint8_t kAddress = 0x0E, kIdentity = 0x10, kStatus = 0x02, kData = 0x03;
constexpr double kStep = 0.3e-6;  ///< T
constexpr Duration kPeriod = 5 * kMillisecond;

/// Registers that hold what a vector says, and everything written to them.
struct Registers : host::I2cPart {
  Registers() { bytes[0] = kIdentity; }
  bool write(const Bytes& written) override {
    pointer = written.at(0);
    if (written.size() > 1) writes.push_back({now(), written});
    return true;
  }
  bool read(std::size_t size, Bytes& out) override {
    if (pointer == kData) ++reads;
    for (std::size_t i = 0; i < size; ++i) out.push_back(bytes[(pointer + i) & 0xFF]);
    return true;
  }
  void hold(std::uint8_t from, const Bytes& values) {
    for (std::size_t i = 0; i < values.size(); ++i) bytes[(from + i) & 0xFF] = values[i];
  }
  std::array<std::uint8_t, 256> bytes{};
  std::uint8_t pointer = 0;
  std::vector<std::pair<Time, Bytes>> writes;
  unsigned reads = 0;
};

/// The driver on a part with these registers, until it has read them often enough.
MagnetometerState drive(Registers& registers) {
  bench::reset();
  host::i2c3.connect(kAddress, registers);
  I2cSlot* table[1] = {};
  I2cBus bus{ports::i2c3, 400000, table};
  I2cSlot slot{bus, kAddress, {}, 1};
  table[0] = &slot;
  Ist8310 compass{nullptr, slot};
  bus.start();
  MagnetometerState state;
  for (unsigned i = 0; i < 100 && registers.reads < 3; ++i) {
    host::advance(kPeriod);
    compass.update();
    if (compass.state.valid) state = compass.state;
  }
  return state;
}

void put_settings(Findings& findings, const Registers& registers) {
  std::vector<Setting> settings;
  Duration shortest = kSecond;
  for (std::size_t i = 0; i < registers.writes.size(); ++i) {
    const bool last = i + 1 == registers.writes.size();
    const Duration wait = last ? kPeriod : registers.writes[i + 1].first - registers.writes[i].first;
    shortest = std::min(shortest, wait);
    settings.push_back({registers.writes[i].second.at(0), registers.writes[i].second.at(1), wait});
  }
  findings.writes = settings;
  findings.put_least("wait_between", Dimension::time, static_cast<double>(shortest) * 1e-9);
  findings.put({"reset_low", "reset_high"}, Dimension::time, {});
  findings.put({"read_back"}, 0);
}

void put_field(Findings& findings, const MagnetometerState& state) {
  std::vector<double> field, on_chip, counts;
  for (unsigned i = 0; i < 3; ++i) {
    field.push_back(state.field[i]);
    on_chip.push_back(i == 1 ? -state.field[i] : state.field[i]);
    counts.push_back(std::round(on_chip[i] / kStep));
  }
  findings.put({"field", "betaflight", "mag", "magnetic"}, Dimension::field, field, {1e-5, 1e-11});
  findings.put({"counts", "raw"}, counts);
  for (double& value : on_chip) value *= 1e6;
  findings.put({"field_ut_as_on_chip"}, on_chip);
}

/// A part model in a field, with a clock of its own.
class TimedCompass {
 public:
  /// @param field  forward, left and up [T]
  explicit TimedCompass(const float (&field)[3]) : field_(field[0], field[1], field[2]) {}
  std::optional<Bytes> ask(const Exchange& asked) { return exchange(part_, asked); }
  void write(std::uint8_t address, std::uint8_t value) { ask({{}, kAddress, {address, value}, {}, {}, {}, {}, {}}); }
  Bytes read(std::uint8_t from, std::size_t size) {
    return ask({{}, kAddress, {from}, Bytes(size), {}, {}, {}, {}}).value_or(Bytes{});
  }
  void wait_ms(unsigned ms) {
    now_ += emulator::from_ns(std::uint64_t{ms} * 1'000'000);
    due_.run(now_);
  }

 private:
  Eigen::Vector3d field_;
  emulator::Time now_ = emulator::from_ns(100'000'000);
  emulator::EventQueue due_;
  emulator::Ist8310 part_{kAddress,
                          {[this] { return now_; },
                           [this](emulator::Time at, emulator::EventQueue::Action action) { due_.at(at, action); }},
                          [this](emulator::Time) { return field_; }};
};

/// The bytes a part model has in its data registers in this field; with its status before them.
Bytes modelled(const MagnetometerState& state, bool fresh) {
  TimedCompass part(state.field);
  part.write(0x0A, 0x0B);
  part.wait_ms(7);
  if (!fresh) part.read(kData, 6);
  return part.read(kStatus, 7);
}

/// Polls, reads and commands in the order of the vector, a part model in single measurement answering.
void replay(Findings& findings, const Vector& vector, const MagnetometerState& state) {
  TimedCompass part(state.field);
  part.write(0x0A, 0x01);
  for (const Exchange& asked : vector.exchanges) {
    Exchange at_address = asked;
    at_address.address = asked.address.value_or(kAddress);
    // A status that is not there yet comes with time: the source polls.
    std::optional<Bytes> answer = part.ask(at_address);
    for (unsigned ms = 0; ms < 10 && answer != asked.read; ++ms) {
      part.wait_ms(1);
      answer = part.ask(at_address);
    }
    findings.check("the part model's answer to " + hexadecimal(asked.written), answer == asked.read);
  }
}

}  // namespace

Findings decode_ist8310(const Vector& vector) {
  Findings findings;
  Registers registers;
  const Bytes bytes = vector.bytes();
  const bool with_status = bytes.size() == 7;
  if (!bytes.empty()) registers.hold(with_status ? kStatus : kData, bytes);
  for (const Exchange& exchange : vector.exchanges) {
    if (!exchange.read.empty() && !exchange.written.empty()) registers.hold(exchange.written[0], exchange.read);
  }
  const MagnetometerState state = drive(registers);
  put_settings(findings, registers);
  findings.put_prose("sequence");
  findings.put({"who_am_i", "chip_id", "identity"}, registers.bytes[0]);
  const bool has_data =
      std::any_of(&registers.bytes[kData], &registers.bytes[kData + 6], [](int it) { return it != 0; });
  const bool taken = has_data ? state.valid : !registers.writes.empty();
  findings.put({"accepted"}, taken ? 1 : 0);
  if (!taken) {
    findings.refuse();
    return findings;
  }
  if (has_data) put_field(findings, state);
  if (with_status) {
    const bool fresh = modelled(state, true) == bytes;
    findings.put({"ready"}, fresh ? 1 : 0);
    findings.check("the part model's registers", fresh || modelled(state, false) == bytes);
  } else if (!bytes.empty()) {
    const Bytes answer = modelled(state, true);
    findings.check("the part model's registers", Bytes(answer.begin() + 1, answer.end()) == bytes);
  }
  replay(findings, vector, state);
  return findings;
}

}  // namespace finemote::evidence
