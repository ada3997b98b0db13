#include "emulator/scenario/grammar.hpp"

#include "emulator/scenario/build.hpp"

namespace finemote::scenario {
namespace {

/// How far `name` is a member of the family: the text behind `stem` is 0 to `last` in plain digits.
bool is_of_family(std::string_view name, std::string_view stem, int last) {
  if (last < 0) return name == stem;
  if (name.substr(0, stem.size()) != stem) return false;
  const std::string_view digits = name.substr(stem.size());
  const bool plain = !digits.empty() && digits.size() <= 3 && (digits.size() == 1 || digits[0] != '0') &&
                     digits.find_first_not_of("0123456789") == std::string_view::npos;
  return plain && std::stoi(std::string(digits)) <= last;
}

template <class Row>
const Row* find_row(const std::vector<Row>& rows, std::string_view name, int Row::*last) {
  for (const Row& row : rows) {
    if (is_of_family(name, row.name, row.*last)) return &row;
  }
  return nullptr;
}

}  // namespace

const Model* find_model(std::string_view type) {
  for (const Model& model : models()) {
    if (model.type == type) return &model;
  }
  return nullptr;
}

const std::vector<PortKind>& port_kinds() {
  const Verb dma_error = fault("dma_error", "the receive stream gets a bus error", {});
  static const std::vector<PortKind> kKinds{
      {"serial",
       "serial port",
       {"usart1", "usart3", "usart6", "usart2", "uart4", "uart5"},
       {silent("nothing arrives"),
        fault("noise", "bytes with a framing error", {required(integer("bytes", "", "how many", 1, 1e9))}), dma_error}},
      {"i2c",
       "I2C port",
       {"i2c1", "i2c2", "i2c3"},
       {fault(
            "nack", "an address that is there does not acknowledge",
            {required(integer("address", "", "7 bits", 0, 127)), required(integer("times", "", "how often", 1, 1e9))}),
        fault("hold_sda", "a part holds the data line",
              {integer("clocks", "", "until so many clocks; for ever if absent", 1, 1e9)}),
        stimulus("release_sda", "releases the data line", {}),
        fault("disturb", "STARTs seen as misplaced", {required(integer("starts", "", "how many", 1, 1e9))}),
        fault("lose", "STARTs lost to another master", {required(integer("starts", "", "how many", 1, 1e9))})}},
      {"can",
       "CAN port",
       {"can1", "can2"},
       {fault("disturb", "destroys frames on the wire", {required(integer("frames", "", "how many", 1, 1e9))}),
        silent("no node receives or acknowledges")}},
      {"spi", "SPI port", {"spi1", "spi2", "spi3"}, {dma_error}},
      {"adc",
       "converter",
       {"adc3"},
       {stimulus("volts", "at an input",
                 {required(integer("input", "", "", 0, 15)), required(number("volts", "V", "at the pin", 0, 3.3))}),
        silent("converts nothing")}},
      {"pwm",
       "PWM header",
       {"pwm1", "pwm2", "pwm3", "pwm4", "pwm5", "pwm6", "pwm7", "imu_heater", "buzzer", "led_red", "led_green",
        "led_blue"},
       {}},
  };
  return kKinds;
}

const PortKind* kind_of_port(std::string_view port) {
  for (const PortKind& kind : port_kinds()) {
    for (const std::string& name : kind.ports) {
      if (name == port) return &kind;
    }
  }
  return nullptr;
}

const std::vector<Verb>& pin_verbs() {
  static const std::vector<Verb> kVerbs{
      stimulus("high", "drives the pin externally: the user key is PA0, low when pressed", {}),
      stimulus("low", "drives the pin externally: the user key is PA0, low when pressed", {}),
      stimulus("release", "no longer drives the pin", {})};
  return kVerbs;
}

const std::vector<Verb>& board_verbs() {
  static const std::vector<Verb> kVerbs{fault(
      "reset", "pulls the reset pin at any point of an operation; a part interrupted in the middle of a byte holds SDA",
      {})};
  return kVerbs;
}

const std::vector<Member>& part_members() {
  static const std::vector<Member> kMembers{required(text("type", "its model")), required(text("name", ""))};
  return kMembers;
}

const std::vector<Member>& event_members() {
  static const std::vector<Member> kMembers{
      required(integer("t_ns", "ns", "when, since the first release", 0, kLongest)),
      required(text("do", "what happens"))};
  return kMembers;
}

const std::vector<Member>& expectation_members() {
  static const std::vector<Member> kMembers{
      required(integer("from_ns", "ns", "the first look, since the first release", 0, kLongest)),
      integer("to_ns", "ns", "the last look; without, `from_ns`", 0, kLongest),
      required(row(Kind::part, "part", "", "whose value")),
      required(text("value", "")),
      required(number("min", "", "")),
      required(number("max", "", "")),
  };
  return kMembers;
}

const Verb* find_verb(const std::vector<Verb>& verbs, std::string_view name) {
  for (const Verb& verb : verbs) {
    if (verb.name == name) return &verb;
  }
  return nullptr;
}

const Member* find_member(const std::vector<Member>& members, std::string_view name) {
  return find_row(members, name, &Member::last);
}

const Quantity* find_quantity(const std::vector<Quantity>& values, std::string_view name) {
  return find_row(values, name, &Quantity::last);
}

std::vector<std::string> names_of(const std::string& name, int last) {
  if (last < 0) return {name};
  std::vector<std::string> names;
  for (int i = 0; i <= last; ++i) names.push_back(name + std::to_string(i));
  return names;
}

}  // namespace finemote::scenario
