// PCA9685: what a part model's registers hold after the vector's exchanges, and after the same wish of our driver.
#include "finemote/pca9685.hpp"

#include <set>

#include "emulator/parts/pca9685.hpp"
#include "finemote/bench/bench.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/evidence/i2c_replay.hpp"

namespace finemote::evidence {
namespace {

constexpr std::uint8_t kAddress = 0x40;
constexpr std::uint8_t kMode1 = 0x00, kMode2 = 0x01, kLed0 = 0x06, kAllLed = 0xFA, kPrescale = 0xFE;
constexpr std::uint8_t kRestart = 0x80, kAutoIncrement = 0x20, kSleep = 0x10, kFull = 0x10;
constexpr double kOscillator = 25e6;

/// The emulator's part, as the driver's wire sees it.
struct Wired : host::I2cPart {
  explicit Wired(emulator::Pca9685& part) : part(part) {}
  bool write(const Bytes& bytes) override {
    written.push_back(bytes);
    return exchange(part, {{}, kAddress, bytes, {}, {}, {}, {}, {}}).has_value();
  }
  bool read(std::size_t size, Bytes& bytes) override {
    const auto answer = exchange(part, {{}, kAddress, {}, Bytes(size), {}, {}, {}, {}});
    bytes = answer.value_or(Bytes{});
    return answer.has_value();
  }
  emulator::Pca9685& part;
  std::vector<Bytes> written;
};

class Part {
 public:
  explicit Part(unsigned address) : address_(address), model_(static_cast<std::uint8_t>(address)) {}

  std::optional<Bytes> run(const Exchange& asked) { return exchange(model_, asked); }
  [[nodiscard]] unsigned reg(unsigned number) {
    Exchange read;
    read.address = address_;
    read.written = {static_cast<std::uint8_t>(number)};
    read.read = {0};
    return exchange(model_, read).value_or(Bytes{0})[0];
  }
  void set(unsigned number, unsigned value) {
    Exchange write;
    write.address = address_;
    write.written = {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(value)};
    exchange(model_, write);
  }
  emulator::Pca9685& model() { return model_; }

 private:
  unsigned address_;
  emulator::Pca9685 model_;
};

/// A register that the first exchange about it finds set. RESTART cannot be written: it comes of falling asleep.
void set_before(Part& part, unsigned number, unsigned value) {
  if (number != kMode1) return part.set(number, value);
  const unsigned mode = value & ~unsigned{kRestart};
  if ((value & kRestart) != 0) {
    part.set(kMode1, mode & ~unsigned{kSleep});
    part.set(kMode1, mode | kSleep);
  }
  part.set(kMode1, mode);
}

/// What a source's exchanges find set, whoever has set it before: reads of what they have not written themselves, and a
/// part that runs where it is put to sleep for a restart.
void prepare(Part& part, const Vector& vector) {
  std::set<unsigned> known;
  for (const Exchange& asked : vector.exchanges) {
    if (asked.written.empty()) continue;
    const unsigned from = asked.written[0];
    const bool puts_asleep = from == kMode1 && asked.written.size() == 2 && (asked.written[1] & kRestart) != 0 &&
                             (asked.written[1] & kSleep) != 0;
    if (puts_asleep && known.empty()) part.set(kMode1, asked.written[1] & ~unsigned{kRestart | kSleep});
    for (unsigned i = 1; i < asked.written.size(); ++i) known.insert(from + i - 1);
    for (unsigned i = 0; i < asked.read.size(); ++i) {
      if (known.insert(from + i).second) set_before(part, from + i, asked.read[i]);
    }
  }
}

/// Which channel the last exchange is about; 16: all or none.
unsigned channel_of(const Vector& vector) {
  for (auto asked = vector.exchanges.rbegin(); asked != vector.exchanges.rend(); ++asked) {
    if (asked->written.empty() || asked->written[0] < kLed0 || asked->written[0] >= kAllLed) continue;
    if (asked->written.size() + asked->read.size() > 5) return 16;
    return (asked->written[0] - unsigned{kLed0}) / 4;
  }
  return 16;
}

void put_modes(Findings& findings, Part& part) {
  const unsigned mode = part.reg(kMode1);
  findings.put({"mode1"}, mode);
  findings.put({"mode2"}, part.reg(kMode2));
  findings.put({"invert", "inverted"}, part.reg(kMode2) >> 4 & 1);
  findings.put({"change_on_ack"}, part.reg(kMode2) >> 3 & 1);
  findings.put({"totem_pole"}, part.reg(kMode2) >> 2 & 1);
  findings.put({"sleep", "asleep"}, (mode & kSleep) != 0 ? 1 : 0);
  findings.put({"restart"}, (mode & kRestart) != 0 ? 1 : 0);
  findings.put({"auto_increment", "autoincrement"}, (mode & kAutoIncrement) != 0 ? 1 : 0);
  findings.put({"all_call", "allcall"}, mode & 1);
  findings.put({"sub_address_1", "subaddr1"}, mode >> 3 & 1);
  findings.put({"external_clock", "extclk"}, mode >> 6 & 1);
  findings.put({"prescale"}, part.reg(kPrescale));
  findings.put({"frequency"}, Dimension::frequency, {kOscillator / 4096 / (part.reg(kPrescale) + 1)}, {0.02, 0});
}

void put_channels(Findings& findings, Part& part, unsigned channel, const Json& expected) {
  std::vector<double> on, off, full_on, full_off;
  for (unsigned c = 0; c < 16; ++c) {
    const unsigned led = kLed0 + 4 * c;
    on.push_back(part.reg(led) | (part.reg(led + 1) & 0x0FU) << 8);
    off.push_back(part.reg(led + 2) | (part.reg(led + 3) & 0x0FU) << 8);
    full_on.push_back((part.reg(led + 1) & kFull) != 0 ? 1 : 0);
    full_off.push_back((part.reg(led + 3) & kFull) != 0 ? 1 : 0);
  }
  if (channel < 16) {
    findings.put({"channel"}, channel);
    findings.put({"on"}, on[channel]);
    findings.put({"off"}, off[channel]);
    findings.put({"full_on"}, full_on[channel]);
    findings.put({"full_off"}, full_off[channel]);
    return;
  }
  findings.put_text("channel", {"all"});
  // One value where the source has one for all.
  const auto put_all = [&](const char* name, const std::vector<double>& values) {
    const bool one = !expected.contains(name) || !expected.at(name).is_array();
    const bool equal = std::vector<double>(16, values[0]) == values;
    findings.put({name}, one && equal ? std::vector<double>{values[0]} : values);
  };
  put_all("on", on);
  put_all("off", off);
  put_all("full_on", full_on);
  put_all("full_off", full_off);
}

/// "sleep, prescale, wake" from what was written.
std::string steps_of(const std::vector<Bytes>& written) {
  std::string steps;
  for (const Bytes& bytes : written) {
    if (bytes.size() != 2) continue;
    const bool mode = bytes[0] == kMode1 && (bytes[1] & kRestart) == 0;
    if (!mode && bytes[0] != kPrescale) continue;
    steps += (steps.empty() ? "" : ", ") + std::string(!mode                      ? "prescale"
                                                       : (bytes[1] & kSleep) != 0 ? "sleep"
                                                                                  : "wake");
  }
  return steps;
}

/// What our driver does to such a part: its bring-up, then this pulse on a channel.
struct Driven {
  explicit Driven(unsigned channel, std::uint32_t counts) : part(kAddress), wire(part.model()) {
    bench::reset();
    host::i2c2.connect(kAddress, wire);
    I2cSlot* table[1] = {};
    I2cBus bus{ports::i2c2, 400000, table};
    I2cSlot slot{bus, kAddress, {}, 1};
    table[0] = &slot;
    Pca9685 pwm{slot};
    bus.start();
    const auto count_ns = 1000 * (Pca9685::prescale({}) + 1) / 25;
    pwm.set(static_cast<std::uint8_t>(channel), counts * static_cast<std::uint32_t>(count_ns));
    for (int i = 0; i < 30; ++i) {
      pwm.flush();
      host::advance(5 * kMillisecond);
    }
  }
  Part part;
  Wired wire;
};

/// Where the vector switches a channel on at 0, as our driver always does, ours leaves the same registers.
void check_driver(Findings& findings, Part& part, unsigned channel) {
  if (channel >= 16) return;
  const unsigned led = kLed0 + 4 * channel;
  const unsigned off = part.reg(led + 2) | part.reg(led + 3) << 8;
  const bool is_off = (off & 0x1000) != 0, is_ours = part.reg(led) == 0 && part.reg(led + 1) == 0;
  if (!is_ours || (!is_off && off == 0)) return;
  Driven driven(channel, is_off ? 0 : off);
  for (unsigned i = 0; i < 4; ++i)
    findings.check("our driver's registers of the channel", driven.part.reg(led + i) == part.reg(led + i));
}

}  // namespace

Findings decode_pca9685(const Vector& vector) {
  Findings findings;
  const unsigned address =
      !vector.exchanges.empty() ? vector.exchanges[0].address.value_or(kAddress) : unsigned{kAddress};
  Part part(address);
  prepare(part, vector);
  bool acknowledged = true;
  for (const Exchange& asked : vector.exchanges) {
    Exchange at_address = asked;
    at_address.address = asked.address.value_or(address);
    const std::optional<Bytes> answer = part.run(at_address);
    acknowledged = acknowledged && answer.has_value();
    findings.check("the part model's answer to " + hexadecimal(asked.written), answer == asked.read);
  }
  findings.put({"accepted", "acknowledged"}, acknowledged ? 1 : 0);
  findings.put({"address"}, address);
  const unsigned channel = channel_of(vector);
  put_modes(findings, part);
  put_channels(findings, part, channel, vector.expected);
  check_driver(findings, part, channel);
  findings.put_text("sequence", {steps_of(Driven(0, 1).wire.written)});
  return findings;
}

}  // namespace finemote::evidence
