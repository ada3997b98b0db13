// DJI's motors: command frames from torques, and feedback frames to angle, speed, current and temperature.
#include "finemote/devices/dji_gm6020.hpp"
#include "finemote/devices/dji_m2006.hpp"
#include "finemote/devices/dji_m3508.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "emulator/parts/dji_motor.hpp"
#include "finemote/bench/bench.hpp"
#include "source_dir.hpp"
#include "tests/evidence/decoders.hpp"
#include "tests/read.hpp"

namespace finemote::evidence {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSteps = 8192;  ///< of the rotor's encoder
constexpr double kRpm = kTurn / 60;
constexpr Time kBegin = kMillisecond;  ///< of a vector, on the bench

/// What sets the motors apart, and the identifiers of their frames as their descriptors have them.
struct Kind {
  const DjiMotorKind* motor;
  double gear;
  Json descriptor;

  [[nodiscard]] unsigned feedback_base() const { return descriptor.at("bus").at("receives").at("base"); }
  [[nodiscard]] const Json& commands() const { return descriptor.at("frames").at(1).at("identifiers"); }
  /// Of the first motor in a command frame; 0 where it is no command frame of this kind.
  [[nodiscard]] unsigned first_id(unsigned frame) const {
    for (const Json& entry : commands()) {
      if (entry.at("identifier") == frame) return entry.at("ids").at(0);
    }
    return 0;
  }
  /// Torque at the output for a command word, and back.
  [[nodiscard]] double torque_per_ampere() const { return motor->torque_per_ampere * gear; }
  [[nodiscard]] double ampere_per_step() const { return double{motor->full_current} / motor->full; }
};

Kind kind_of(const char* type, const DjiMotorKind& motor, double gear) {
  const std::string file = std::string("/schemas/devices/") + type + ".json";
  return {&motor, gear, Json::parse(test::read(finemote::test::source_dir() + file))};
}

/// One of our motors on a bus, whichever kind it is.
class Bench {
 public:
  Bench(const Kind& kind, unsigned id, CanShare share) {
    bench::reset();
    slot_ = std::make_unique<CanSlot>(bus_, static_cast<std::uint16_t>(id),
                                      CanIds{static_cast<std::uint16_t>(kind.feedback_base() + id)},
                                      std::int32_t{CanSlot::kAnyTime}, std::uint8_t{1}, share);
    const auto gear = static_cast<float>(kind.gear);
    if (kind.motor == &detail::kC620) motor_ = std::make_unique<Holder<DjiM3508>>(DjiM3508::Config{gear}, *slot_);
    if (kind.motor == &detail::kC610) motor_ = std::make_unique<Holder<DjiM2006>>(DjiM2006::Config{gear}, *slot_);
    if (kind.motor == &detail::kGm6020) motor_ = std::make_unique<Holder<DjiGm6020>>(DjiGm6020::Config{}, *slot_);
    table_[0] = slot_.get();
    bus_.start();
  }
  DjiMotor& motor() { return motor_->get(); }
  void receive(Time at, unsigned id, const Bytes& bytes) {
    CanFrame frame;
    frame.id = static_cast<std::uint16_t>(id);
    frame.size = static_cast<std::uint8_t>(std::min<std::size_t>(bytes.size(), 8));
    std::copy_n(bytes.begin(), frame.size, frame.data);
    host::can1.feed(at, frame);
    host::advance(at + kMicrosecond - now());
    motor().update();
  }
  /// The frame that carries this torque.
  Bytes command(double torque) {
    motor().command.torque = static_cast<float>(torque);
    motor().command.origin = now();
    motor().command.valid = true;
    motor().handle();
    bus_.flush();
    host::advance(2 * kMillisecond);
    if (host::can1.sent.empty()) return {};
    const CanFrame& frame = host::can1.sent.back().frame;
    return {frame.data, frame.data + frame.size};
  }

 private:
  struct AnyMotor {
    virtual ~AnyMotor() = default;
    virtual DjiMotor& get() = 0;
  };
  template <class Motor>
  struct Holder : AnyMotor {
    Holder(const typename Motor::Config& config, CanSlot& slot) : motor(config, slot) {}
    DjiMotor& get() override { return motor; }
    Motor motor;
  };

  std::unique_ptr<CanSlot> slot_;
  std::unique_ptr<AnyMotor> motor_;
  CanSlot* table_[1] = {};
  CanBus bus_{ports::can1, 1000000, table_};
};

// ------------------------------------------------------------------------------------------------------------ the
// model

/// A part model that is given one command frame and asked for one report.
struct Modelled {
  int command = 0;
  double current = 0;
  Bytes report;
};

struct Rotor {
  double angle = 0, speed = 0, temperature = 0;
};

Modelled model(const Kind& kind, unsigned command_id, unsigned word, const Bytes& command, const Rotor& rotor) {
  namespace em = emulator;
  em::World world;
  em::CanLine line(world);
  Modelled result;
  std::optional<em::CanFrame> order;
  line.attach({[&] { return order; }, [&](const em::CanFrame&, em::CanOutcome) { order.reset(); },
               [&](const em::CanFrame& frame) { result.report.assign(frame.data.begin(), frame.data.end()); }});
  line.attach({});
  em::DjiMotor::Figures figures;
  figures.command_id = command_id;
  figures.word = word;
  figures.full_word = kind.motor->full;
  figures.full_current = kind.motor->full_current;
  figures.gear = kind.gear;
  figures.torque_per_ampere = kind.torque_per_ampere();
  figures.zero = rotor.angle + kTurn / kSteps / 2;  // in the middle of the step
  figures.temperature = rotor.temperature;
  figures.phase = em::from_ns(1'000'000);
  em::MotorShaft::Parameters shaft;
  shaft.speed = rotor.speed / kind.gear;
  em::DjiMotor motor(world, line, figures, shaft);
  em::CanFrame frame{command_id, 8, {}};
  std::copy_n(command.begin(), 8, frame.data.begin());
  order = frame;
  line.request();
  world.queue().run(em::from_ns(1'500'000));
  result.command = motor.command();
  result.current = motor.current();
  return result;
}

Bytes frame_with(unsigned word, int value) {
  Bytes frame(8);
  frame[2 * word] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
  frame[2 * word + 1] = static_cast<std::uint8_t>(value & 0xFF);
  return frame;
}

// -------------------------------------------------------------------------------------------------------------
// feedback

/// Where the source counts turns from: a home may be set at a value, which reads 0 from then on.
std::vector<double> from_home(const std::vector<double>& counted, const Json& expected) {
  std::vector<double> values;
  double home = 0;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (expected.is_array() && i < expected.size() && expected[i] == 0 && i > 0 && counted[i] == counted[i - 1])
      home = counted[i];
    values.push_back(counted[i] - home);
  }
  return values;
}

void put_state(Findings& findings, const Kind& kind, const MotorState& state) {
  const double rotor_angle = state.angle * kind.gear, rotor_speed = state.speed * kind.gear;
  const double current = state.torque / kind.torque_per_ampere();
  const double step = kTurn / kSteps;
  findings.put({"angle", "rotor_angle", "position"}, Dimension::angle, {rotor_angle}, {1e-5, 1e-5}, kTurn);
  findings.put({"angle_raw", "encoder_raw", "ecd"}, Dimension::number, {std::round(rotor_angle / step)}, {0, 0},
               kSteps);
  findings.put({"", "rotor", "speed", "velocity", "rotor_speed"}, Dimension::angular_speed, {rotor_speed}, {1e-5, 0});
  findings.put({"rotor_rpm", "rpm", "speed_rpm", "speed_raw", "velocity_raw"}, {std::round(rotor_speed / kRpm)});
  findings.put({"output", "output_speed"}, Dimension::angular_speed, {state.speed});
  findings.put({"current", "torque_current"}, Dimension::current, {current});
  findings.put({"current_raw", "torque_current_raw"}, {std::round(current / kind.ampere_per_step())});
  findings.put({"torque", "output_torque"}, Dimension::torque, {state.torque});
  findings.put({"rotor_torque"}, Dimension::torque, {state.torque / kind.gear});
  if (kind.motor->tells_temperature) findings.put({"temperature", "temp"}, Dimension::temperature, {state.temperature});
}

Findings decode_feedback(const Kind& kind, const Vector& vector) {
  Findings findings;
  const unsigned can_id = vector.can_id.value_or(kind.feedback_base() + 1);
  const unsigned id = can_id - kind.feedback_base();
  Bench bench(kind, id, {});
  std::vector<double> counted;
  unsigned taken = 0;
  for (const Burst& burst : vector.bursts) {
    const Time before = bench.motor().state.origin;
    bench.receive(kBegin + burst.at, can_id, burst.bytes);
    taken += bench.motor().state.valid && bench.motor().state.origin != before ? 1 : 0;
    counted.push_back(std::round(bench.motor().state.angle * kind.gear / (kTurn / kSteps)));
  }
  findings.put({"accepted", "valid"}, taken > 0 ? 1 : 0);
  findings.put({"frames"}, taken);
  if (taken == 0) {
    findings.refuse();
    return findings;
  }
  const MotorState& state = bench.motor().state;
  put_state(findings, kind, state);
  findings.put({"motor_id", "id"}, id);
  findings.put({"gear", "gear_ratio"}, kind.gear);
  const Json& unwrapped =
      vector.expected.contains("angle_unwrapped_raw") ? vector.expected.at("angle_unwrapped_raw") : Json();
  findings.put({"angle_unwrapped_raw", "position_raw"}, from_home(counted, unwrapped));

  const double current = state.torque / kind.torque_per_ampere();
  const int word = static_cast<int>(std::lround(current / kind.ampere_per_step()));
  const Modelled modelled =
      model(kind, 0x200, 0, frame_with(0, word), {state.angle * kind.gear, state.speed * kind.gear, state.temperature});
  Bytes last = vector.bursts.back().bytes;
  if (!kind.motor->tells_temperature && last.size() > 6) last[6] = 0;
  findings.check("the report of the part model", modelled.report == last);
  return findings;
}

// -------------------------------------------------------------------------------------------------------------
// commands

/// Torque at the output that the source wants of a motor in the frame.
double torque_of(const Kind& kind, const Vector& vector, unsigned word, const Modelled& modelled) {
  const Json& expected = vector.expected;
  const bool own = expected.contains("slot") && expected.at("slot") == word + 1;
  double current = modelled.current;
  if (own && expected.contains("command_raw"))
    current = expected.at("command_raw").get<double>() * kind.ampere_per_step();
  if (own && expected.contains("command_a") && kind.motor != &detail::kGm6020) current = expected.at("command_a");
  return current * kind.torque_per_ampere();
}

Findings decode_command(const Kind& kind, const Vector& vector, unsigned frame, bool ours) {
  Findings findings;
  const Bytes bytes = vector.bytes();
  findings.put({"accepted"}, bytes.size() == 8 ? 1 : 0);
  if (bytes.size() != 8) {
    findings.refuse();
    return findings;
  }
  std::vector<double> words, currents;
  for (unsigned word = 0; word < 4; ++word) {
    const Modelled modelled = model(kind, frame, word, bytes, {});
    words.push_back(modelled.command);
    currents.push_back(modelled.current);
    const std::string name = "command_" + std::to_string(word);
    findings.put({name.c_str()}, Dimension::current, {modelled.current});
    findings.put({(name + "_raw").c_str()}, modelled.command);
    if (vector.expected.contains("slot") && vector.expected.at("slot") == word + 1) {
      findings.put({"slot"}, word + 1);
      findings.put({"command_raw"}, modelled.command);
      findings.put({"command", "current"}, Dimension::current, {modelled.current});
    }
    if (!ours) continue;
    const CanShare share{static_cast<std::uint16_t>(frame), static_cast<std::uint8_t>(2 * word), 2};
    Bench bench(kind, kind.first_id(frame) + word, share);
    const Bytes sent = bench.command(torque_of(kind, vector, word, modelled));
    findings.check("our command frame", sent == frame_with(word, bytes[2 * word] << 8 | bytes[2 * word + 1]));
  }
  findings.put({"commands_raw"}, words);
  findings.put({"commands"}, Dimension::current, currents);
  findings.put_text("byte_order", {"big"});
  if (vector.expected.contains("slot")) {  // the others, where they all hold the same byte
    Bytes others;
    for (unsigned i = 0; i < 8; ++i) {
      if (i / 2 + 1 != vector.expected.at("slot")) others.push_back(bytes[i]);
    }
    if (std::count(others.begin(), others.end(), others[0]) == 6)
      findings.put_text("other_bytes_untouched", {hexadecimal({others[0]})});
  }
  return findings;
}

Findings decode(const Kind& kind, const Vector& vector) {
  if (vector.can_id && kind.first_id(*vector.can_id) != 0) {
    Findings findings = decode_command(kind, vector, *vector.can_id, true);
    findings.put_text("mode", {"current"});
    return findings;
  }
  return decode_feedback(kind, vector);
}

}  // namespace

Findings decode_m3508(const Vector& vector) {
  return decode(kind_of("dji_m3508", detail::kC620, 3591.0 / 187), vector);
}

Findings decode_c610(const Vector& vector) { return decode(kind_of("dji_m2006", detail::kC610, 36), vector); }

/// Frames 0x1FF and 0x2FF command a voltage, which the driver never does: its part model reads them all the same.
Findings decode_gm6020(const Vector& vector) {
  const Kind kind = kind_of("dji_gm6020", detail::kGm6020, 1);
  if (vector.can_id != 0x1FFU && vector.can_id != 0x2FFU) return decode(kind, vector);
  DjiMotorKind by_voltage = detail::kGm6020;
  by_voltage.full = 30000;
  Kind other = kind;
  other.motor = &by_voltage;
  Findings findings = decode_command(other, vector, *vector.can_id, false);
  findings.put_text("mode", {"current"});
  findings.put({"command"}, Dimension::voltage, {});
  return findings;
}

}  // namespace finemote::evidence
