// A program that commands the robot.
#include "emulator/parts/computer.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/serial_line.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// Of 20 ms: a program of a system for all purposes is woken up to a millisecond early or late.
constexpr double kWakePpm = 50'000;

class ComputerElement : public Element {
 public:
  ComputerElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name),
        model(outfit.board().world(), outfit.usart_of(part), format_of(part),
              {maybe<std::uint32_t>(part, "layout", 0), maybe<std::string>(part, "values", "")}, period_of(part),
              phase_of(part)) {
    model.on_frame = [this](Time begin, Time end) { return record_sample(begin, end); };
  }

  Computer model;
};

void command(ComputerElement& part, const Json& event) {
  SentCommands& commands = part.model.commands;
  commands.valid = maybe(event, "valid", commands.valid);
  commands.value = maybe(event, "value", commands.value);
}

void silence(ComputerElement& part, const Json& event) { part.model.silent = is_on(event); }

void damage(ComputerElement& part, const Json& event) { part.model.damaged_frames = need<unsigned>(event, "frames"); }

}  // namespace

Model host_computer() {
  using Row = Rows<ComputerElement>;
  return {
      .type = "host_computer",
      .summary = "a program that sends a frame of commands every `period_ns`, all of them 0 at first",
      .figures = serial_line() + pace(20e6) +
                 std::vector<Member>{
                     integer("layout", "", "number of the frames", 0, 4294967295.0),
                     text("values", "of a frame: a letter for each, as in Python's `struct`; `v` is a validity byte")},
      .clock_tolerance_ppm = kWakePpm,
      .verbs = {with_member(Row::stimulus("command", "what the program wants of all that it commands",
                                          {flag("valid", "whether the commands count"),
                                           number("value", "", "of every number of a command", -1e6, 1e6)},
                                          command)),
                Row::fault("silent", "sends nothing", {until()}, silence),
                Row::fault("damage", "frames with a wrong checksum", {count("frames")}, damage)},
      .values = {Row::value("frames", "", "sent so far",
                            [](ComputerElement& part) -> double { return part.model.frames(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
