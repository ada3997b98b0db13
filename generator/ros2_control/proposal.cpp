#include "generator/ros2_control/proposal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "generator/xml/escape.hpp"

namespace finemote::gen::ros2_control {
namespace {

constexpr int kMotorsOfBus = 8, kMotorsOfFrame = 4, kOutputsOfDriver = 16;
constexpr int kFirstDriverAddress = 0x40;  // of a PCA9685
const char* const kCanPorts[] = {"can1", "can2"};
constexpr int kMostDrivers = 8;
constexpr int kUsualPeriodMs = 10;

/// [ms]; exact unless rw_rate is no divisor of 1000 Hz.
int period_for(const Hardware& hardware) {
  return hardware.rate ? static_cast<int>(std::clamp(std::round(1000 / *hardware.rate), 1.0, 1000.0)) : kUsualPeriodMs;
}

bool has(const std::vector<std::string>& interfaces, std::string_view name) {
  return std::find(interfaces.begin(), interfaces.end(), name) != interfaces.end();
}

/// For a comment, which must not hold `--`.
std::string for_comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--")) text.replace(at, 2, "- -");
  return text;
}

/// Collects the lines of the element: buses as devices ask for them, then trees.
class Writer {
 public:
  Proposal run(const std::vector<Hardware>& all) {
    for (const Hardware& hardware : all) tree(hardware);
    std::string text = "  <finemote version=\"1\">\n";
    Writer head;  // guesses in the order of the text: board and buses come first
    head.guess("    ", "the board");
    head.lines_ += "    <board name=\"robomaster_type_c\"/>\n\n";
    head.buses(motors_, outputs_, sensors_);
    text += head.lines_ + lines_;
    proposal_.guesses.insert(proposal_.guesses.begin(), head.proposal_.guesses.begin(), head.proposal_.guesses.end());
    proposal_.lacking.emplace_back(
        "execution times: every bound rests on assumed ones until there is a timing file (finemote wcet)");
    for (const std::string& what : proposal_.lacking) text += "    <!-- lacking: " + for_comment(what) + " -->\n";
    proposal_.text = text + "  </finemote>\n";
    return std::move(proposal_);
  }

 private:
  void guess(const std::string& indent, const std::string& what) {
    proposal_.guesses.push_back(what);
    lines_ += fmt::format("{}<!-- guess: {} -->\n", indent, for_comment(what));
  }

  void lack(const std::string& what) { proposal_.lacking.push_back(what); }

  void buses(int motors, int outputs, int sensors) {
    for (int i = 0; i * kMotorsOfBus < motors; ++i) {
      guess("    ", fmt::format("the port that motors are on, up to {} of them", kMotorsOfBus));
      lines_ += fmt::format("    <bus name=\"motors_{}\" type=\"can\" port=\"{}\" bitrate=\"1Mbit/s\"/>\n", i + 1,
                            kCanPorts[i]);
    }
    if (outputs > 0) {
      guess("    ", "servos and thrusters on PCA9685 drivers, and the port these are on");
      lines_ += "    <bus name=\"pulse_i2c\" type=\"i2c\" port=\"i2c2\" clock=\"400kHz\"/>\n";
    }
    for (int i = 0; i * kOutputsOfDriver < outputs; ++i)
      lines_ +=
          fmt::format("    <expander name=\"pulses_{}\" model=\"pca9685\" bus=\"pulse_i2c\" address=\"{:#x}\"/>\n",
                      i + 1, kFirstDriverAddress + i);
    if (sensors > 0) {
      guess("    ", "the attitude sensor's type, port and rate");
      lines_ += "    <bus name=\"attitude_uart\" type=\"uart\" port=\"usart1\" baud=\"921600baud\"/>\n";
    }
  }

  void tree(const Hardware& hardware) {
    const std::string name = name_for(hardware.name.empty() ? "robot" : hardware.name);
    const std::string plugin = hardware.plugin.empty() ? "" : ", which ROS drives with " + hardware.plugin;
    std::string outer;
    std::swap(outer, lines_);
    const std::size_t before = proposal_.guesses.size();
    devices_ = 0;
    period_ = period_for(hardware);
    // Sensors stand before what is commanded: handles run in the reverse order.
    for (const bool is_sensor : {true, false})
      for (const Component& part : hardware.parts)
        if ((part.kind == Component::Kind::sensor) == is_sensor) device(hardware, part);
    std::string inner;
    std::swap(inner, lines_);
    lines_ = outer;
    if (devices_ == 0)
      return lack(fmt::format("hardware '{}'{}: nothing in it that a device here could be", hardware.name, plugin));
    std::vector<std::string> of_parts(proposal_.guesses.begin() + static_cast<std::ptrdiff_t>(before),
                                      proposal_.guesses.end());
    proposal_.guesses.resize(before);
    lines_ += fmt::format("\n    <!-- hardware '{}'{} -->\n", for_comment(hardware.name), for_comment(plugin));
    guess_period(hardware);
    guess("    ", "what joins its devices; a type of your own decides more (finemote scaffold device)");
    lines_ +=
        fmt::format("    <device name=\"{}\" type=\"group\" period=\"{}ms\">\n{}    </device>\n", name, period_, inner);
    proposal_.guesses.insert(proposal_.guesses.end(), of_parts.begin(), of_parts.end());
  }

  void guess_period(const Hardware& hardware) {
    if (!hardware.rate) return guess("    ", "the period: rw_rate is not given");
    if (1000 / *hardware.rate != period_)
      guess("    ", fmt::format("the period: rw_rate is {:g} Hz, which is no whole number of ms", *hardware.rate));
  }

  void device(const Hardware& hardware, const Component& part) {
    const std::string what = fmt::format("'{}' of hardware '{}'", part.name, hardware.name);
    switch (part.kind) {
      case Component::Kind::joint:
        return joint(part, what);
      case Component::Kind::sensor:
        return sensor(part, what);
      case Component::Kind::gpio:
        return lack("gpio " + what + ": led, key, battery or a type of your own");
      case Component::Kind::transmission:
        return lack("transmission " + what + ": its reduction and offset, in the params of the device");
    }
  }

  void joint(const Component& part, const std::string& what) {
    if (part.is_mimic) return note("joint '" + part.name + "' follows another one: no device");
    if (part.commands.empty() && part.states.empty())
      return lack("joint " + what + ": what it takes, as it names no interface");
    if (part.commands.empty()) return note("joint '" + part.name + "' takes no command: no device");
    if (part.type.empty()) return lack("joint " + what + ": the robot has no such joint");
    if (!part.can_turn()) return lack(fmt::format("joint {}: it is {}, and nothing here moves that", what, part.type));
    if (driven_.count(part.name) != 0) return lack("joint " + what + ": another device drives it already");
    for (const char* command : {"velocity", "effort"})
      if (has(part.commands, command)) return motor(part, what, command);
    if (has(part.commands, "thrust")) return thruster(part, what);
    if (has(part.commands, "position")) return servo(part, what);
    lack(fmt::format("joint {}: nothing here takes the command '{}'", what, part.commands.front()));
  }

  void note(const std::string& text) { lines_ += "      <!-- " + for_comment(text) + " -->\n"; }

  void motor(const Component& part, const std::string& what, const char* command) {
    if (period_ != period_of_frame_) motors_ = (motors_ + kMotorsOfFrame - 1) / kMotorsOfFrame * kMotorsOfFrame;
    period_of_frame_ = period_;
    if (motors_ == kMotorsOfBus * static_cast<int>(std::size(kCanPorts)))
      return lack("joint " + what + ": both CAN buses have all the motors they take");
    guess("      ", fmt::format("'{}' takes the command '{}': a CAN motor, its type and id", part.name, command));
    add(part, "dji_m3508",
        fmt::format("bus=\"motors_{}\" id=\"{}\" joint=\"{}\"", motors_ / kMotorsOfBus + 1, motors_ % kMotorsOfBus + 1,
                    xml::escaped(part.name)));
    ++motors_;
  }

  void thruster(const Component& part, const std::string& what) {
    pulses(part, what, "pwm_esc", "takes thrust: a propeller on a speed controller, and its channel");
  }

  void servo(const Component& part, const std::string& what) {
    pulses(part, what, "pwm_servo", "takes positions: a servo, and its channel");
  }

  void pulses(const Component& part, const std::string& what, const char* type, const char* because) {
    if (outputs_ == kOutputsOfDriver * kMostDrivers) return lack("joint " + what + ": no driver has a channel left");
    guess("      ", fmt::format("'{}' {}", part.name, because));
    add(part, type,
        fmt::format("bus=\"pulses_{}\" channel=\"{}\" joint=\"{}\"", outputs_ / kOutputsOfDriver + 1,
                    outputs_ % kOutputsOfDriver, xml::escaped(part.name)));
    ++outputs_;
  }

  void sensor(const Component& part, const std::string& what) {
    if (!has(part.states, "orientation.x") && !has(part.states, "angular_velocity.x"))
      return lack("sensor " + what + ": a type of your own (finemote scaffold device)");
    if (sensors_ == 1) return lack("sensor " + what + ": a serial port for a second attitude sensor");
    ++sensors_;
    add(part, "h30_imu",
        "bus=\"attitude_uart\"" + (part.link.empty() ? "" : " link=\"" + xml::escaped(part.link) + "\""));
  }

  void add(const Component& part, const char* type, const std::string& place) {
    if (part.kind == Component::Kind::joint) driven_.insert(part.name);
    lines_ += fmt::format("      <device name=\"{}\" type=\"{}\" {}/>\n", name_for(part.name), type, place);
    ++devices_;
  }

  /// A name that stands for one thing in C++, whatever ROS calls it: letters, digits and single underscores.
  std::string name_for(const std::string& given) {
    std::string name;
    for (const char c : given) {
      const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (is_letter || (!name.empty() && name.back() != '_')) name += is_letter ? c : '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    if (name.empty()) name = "part";
    std::string unique = name;
    for (int n = 2; !names_.insert(lower(unique)).second; ++n) unique = fmt::format("{}_{}", name, n);
    return unique;
  }

  static std::string lower(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return name;
  }

  Proposal proposal_;
  std::string lines_;
  std::set<std::string> names_;  ///< in lower case: names that differ by it alone are refused
  int motors_ = 0, outputs_ = 0, sensors_ = 0;
  std::set<std::string> driven_;  ///< joints that have a device
  int devices_ = 0, period_ = 0;  ///< of the tree; [ms]
  int period_of_frame_ = 0;       ///< of the last motor's tree: motors of one frame have one period
};

}  // namespace

Proposal propose(const std::vector<Hardware>& all) { return Writer().run(all); }

}  // namespace finemote::gen::ros2_control
