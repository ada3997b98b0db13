// What a scenario can make happen at the ports and pins of the board and to the board as a whole, whatever hangs there.
#include "emulator/outfit/outfit.hpp"
#include "emulator/parts/foreign_node.hpp"
#include "emulator/scenario/build.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

std::string port_of(const Json& event) { return need<std::string>(event, "port"); }
Usart& usart(Outfit& outfit, const Json& event) { return *outfit.board().chip().usart(port_of(event)); }
I2c& i2c(Outfit& outfit, const Json& event) { return *outfit.board().chip().i2c(port_of(event)); }
Can& can(Outfit& outfit, const Json& event) { return *outfit.board().chip().can(port_of(event)); }
Adc& adc(Outfit& outfit, const Json& event) { return *outfit.board().chip().adc(port_of(event)); }
unsigned number_in(const Json& event, const char* key) { return need<unsigned>(event, key); }

using Act = void (*)(Outfit& outfit, const Json& event);

Verb fault(const char* name, const char* summary, std::vector<Member> members, Act act) {
  return {name, summary, std::move(members), act, kBusErrors};
}
Verb stimulus(const char* name, const char* summary, std::vector<Member> members, Act act) {
  return {name, summary, std::move(members), act, {}};
}

Verb dma_error() {
  return fault("dma_error", "the receive stream gets a bus error", {}, [](Outfit& outfit, const Json& event) {
    outfit.board().chip().break_dma(port_of(event), DmaWay::receive);
  });
}

constexpr int kMostBytes = 1'000'000;
constexpr std::uint8_t kUsualNoise = 0x55;  // begins no part's frame
constexpr std::int64_t kUsualEvery_ns = 1'000'000;

void send_noise(Outfit& outfit, const Json& event) {
  const auto value = maybe(event, "byte", kUsualNoise);
  Usart& port = usart(outfit, event);
  port.send_in(std::vector<std::uint8_t>(number_in(event, "bytes"), value), port.format());
}

void send_foreign_frames(Outfit& outfit, const Json& event) {
  flood(outfit.board().world(), can(outfit, event).line,
        {need<std::uint32_t>(event, "identifier"), number_in(event, "frames"),
         from_ns(maybe(event, "every_ns", kUsualEvery_ns))});
}

PortKind serial_ports() {
  return {
      "serial",
      "serial port",
      {"usart1", "usart3", "usart6", "usart2", "uart4", "uart5"},
      {fault("silent", "nothing arrives", {until()},
             [](Outfit& outfit, const Json& event) { usart(outfit, event).silent = is_on(event); }),
       fault("noise", "bytes with a framing error", {count("bytes")},
             [](Outfit& outfit, const Json& event) { usart(outfit, event).noisy_bytes = number_in(event, "bytes"); }),
       violating("declared-nodes",
                 fault("flood", "bytes that nobody declared, one after the other at the rate of the port",
                       {required(integer("bytes", "", "how many", 1, kMostBytes)),
                        usually(kUsualNoise, integer("byte", "", "", 0, 255))},
                       send_noise)),
       dma_error()}};
}

PortKind i2c_ports() {
  return {
      "i2c",
      "I2C port",
      {"i2c1", "i2c2", "i2c3"},
      {fault("nack", "an address that is there does not acknowledge",
             {required(integer("address", "", "7 bits", 0, 127)), required(integer("times", "", "how often", 1, 1e9))},
             [](Outfit& outfit, const Json& event) {
               i2c(outfit, event).line.nack(need<std::uint8_t>(event, "address"), number_in(event, "times"));
             }),
       fault("hold_sda", "a part holds the data line",
             {integer("clocks", "", "until so many clocks; for ever if absent", 1, 1e9)},
             [](Outfit& outfit, const Json& event) {
               i2c(outfit, event).line.hold_sda(maybe(event, "clocks", I2cLine::kForever));
             }),
       stimulus("release_sda", "releases the data line", {},
                [](Outfit& outfit, const Json& event) { i2c(outfit, event).line.hold_sda(0); }),
       fault(
           "disturb", "STARTs seen as misplaced", {count("starts")},
           [](Outfit& outfit, const Json& event) { i2c(outfit, event).disturbed_starts = number_in(event, "starts"); }),
       fault("lose", "STARTs lost to another master", {count("starts")},
             [](Outfit& outfit, const Json& event) { i2c(outfit, event).lost_starts = number_in(event, "starts"); })}};
}

PortKind can_ports() {
  return {
      "can",
      "CAN port",
      {"can1", "can2"},
      {fault("disturb", "destroys frames on the wire", {count("frames")},
             [](Outfit& outfit, const Json& event) {
               can(outfit, event).line.disturbed_frames = number_in(event, "frames");
             }),
       violating("declared-nodes",
                 fault("flood", "a node that nobody declared sends frames of eight bytes",
                       {required(integer("identifier", "", "", 0, 2047)), count("frames"),
                        usually(kUsualEvery_ns, integer("every_ns", "ns", "from one to the next", 1'000, kLongest))},
                       send_foreign_frames)),
       fault("silent", "no node receives or acknowledges", {until()},
             [](Outfit& outfit, const Json& event) { can(outfit, event).line.cut = is_on(event); })}};
}

PortKind converters() {
  return {"adc",
          "converter",
          {"adc3"},
          {stimulus("volts", "at an input",
                    {required(integer("input", "", "", 0, 15)), required(number("volts", "V", "at the pin", 0, 3.3))},
                    [](Outfit& outfit, const Json& event) {
                      adc(outfit, event).volts[number_in(event, "input")] = need<double>(event, "volts");
                    }),
           fault("silent", "converts nothing", {until()},
                 [](Outfit& outfit, const Json& event) { adc(outfit, event).dead = is_on(event); })}};
}

/// 1, 0, or -1: nothing drives it.
void drive(Outfit& outfit, const Json& event, int level) {
  const auto [port, number] = pin_place(need<std::string>(event, "pin"));
  outfit.board().chip().gpio(port).drive(number, level);
}

}  // namespace
}  // namespace finemote::emulator

namespace finemote::scenario {

using emulator::Json;
using emulator::Outfit;

const std::vector<PortKind>& port_kinds() {
  static const std::vector<PortKind> kKinds{
      emulator::serial_ports(),
      emulator::i2c_ports(),
      emulator::can_ports(),
      {"spi", "SPI port", {"spi1", "spi2", "spi3"}, {emulator::dma_error()}},
      emulator::converters(),
      {"pwm",
       "PWM header",
       {"pwm1", "pwm2", "pwm3", "pwm4", "pwm5", "pwm6", "pwm7", "imu_heater", "buzzer", "led_red", "led_green",
        "led_orange", "led_blue"},
       {}},
  };
  return kKinds;
}

const std::vector<Verb>& pin_verbs() {
  constexpr const char* kDrives = "drives the pin externally: the user key is PA0, low when pressed";
  static const std::vector<Verb> kVerbs{
      emulator::stimulus("high", kDrives, {}, [](Outfit& outfit, const Json& e) { emulator::drive(outfit, e, 1); }),
      emulator::stimulus("low", kDrives, {}, [](Outfit& outfit, const Json& e) { emulator::drive(outfit, e, 0); }),
      emulator::stimulus("release", "no longer drives the pin", {},
                         [](Outfit& outfit, const Json& e) { emulator::drive(outfit, e, -1); })};
  return kVerbs;
}

const std::vector<Verb>& board_verbs() {
  static const std::vector<Verb> kVerbs{violating(
      "bring-up",
      emulator::fault(
          "reset",
          "pulls the reset pin at any point of an operation; a part interrupted in the middle of a byte holds SDA", {},
          [](Outfit& outfit, const Json&) { outfit.press_reset(); }))};
  return kVerbs;
}

}  // namespace finemote::scenario
