#include "generator/bench_kit/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/bench_kit/bench_ports.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/descriptor/port_signals.hpp"
#include "generator/emit/render.hpp"
#include "generator/output/sha256.hpp"

namespace finemote::gen {
namespace {

using namespace bench_ports;

/// `clock.core_hz` to `clock_core_hz`.
std::string identifier(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::string lines_of_tests(const BenchPlan& plan) {
  std::string text;
  for (const BenchTest& it : plan.tests) {
    text += fmt::format("    {{\"{}\", Group::{}, {}U, {}U, {}, \"{}\"}},\n", it.name, it.group, it.least, it.most,
                        it.is_judged, it.needs);
  }
  return text;
}

std::string enumerators(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "  " + name + ",\n";
  return text;
}

std::vector<std::string> names_of(const std::vector<BenchTest>& tests) {
  std::vector<std::string> names;
  for (const BenchTest& test : tests) names.push_back(identifier(test.name));
  return names;
}

/// `PA9` to `{'A', 9}`.
std::string pin_text(const std::string& pin) { return pin_name(pin).initializer(); }

/// The members of a UartPins.
std::string uart_pins(const Port& port) {
  const PortPin &tx = *signal_pin(port, "tx"), &rx = *signal_pin(port, "rx");
  return fmt::format("{{stm32f4::kUsart{}, {}, {}, {}}}", port.name.back(), pin_text(tx.pin), pin_text(rx.pin),
                     tx.alternate_function);
}

/// Those of the report, of the jumper, and of all serial ports.
std::string serial_pins(const Board& board) {
  std::string all;
  std::size_t count = 0;
  for (const Port& port : board.ports) {
    if (port.name.rfind("usart", 0) != 0) continue;
    all += "    " + uart_pins(port) + ",\n";
    ++count;
  }
  return fmt::format(
      "inline constexpr UartPins kReportPort{};\ninline constexpr UartPins kLoopUart{};\n"
      "inline constexpr UartPins kSerialPorts[{}] = {{\n{}}};\n",
      uart_pins(*board.port(kReport)), uart_pins(*board.port(kSerialLoop)), count, all);
}

/// `{stm32f4::dma::kController2, 0}` of the stream for `rx` or `tx`; `{}`: there is none.
std::string stream_text(const Port& port, const char* signal) {
  const DmaStream* stream = dma_for(port, signal);
  return stream == nullptr
             ? "{}"
             : fmt::format("{{stm32f4::dma::kController{}, {}}}", stream->controller.back(), stream->stream);
}

std::string spi_pins(const Board& board, const char* constant, const char* port_name) {
  const Port& port = *board.port(port_name);
  std::string selects;
  for (const std::string& pin : port.selects) selects += (selects.empty() ? "" : ", ") + pin_text(pin);
  return fmt::format(
      "inline constexpr stm32f4::Pin {0}Selects[] = {{{1}}};\n"
      "inline constexpr SpiPins {0}{{stm32f4::kSpi{2}, {3}, {4}, {5}, {6}, {0}Selects, {7},\n"
      "    {8}, {9}, {10}}};\n",
      constant, selects, port_name[3], pin_text(signal_pin(port, "sck")->pin), pin_text(signal_pin(port, "miso")->pin),
      pin_text(signal_pin(port, "mosi")->pin), signal_pin(port, "sck")->alternate_function, port.selects.size(),
      stream_text(port, "rx"), stream_text(port, "tx"), port.dma.empty() ? 0 : port.dma.front().channel);
}

std::string i2c_pins(const Board& board, const char* constant, const char* port_name) {
  const Port& port = *board.port(port_name);
  return fmt::format("inline constexpr I2cPins {}{{stm32f4::kI2c{}, {}, {}, {}}};\n", constant, port_name[3],
                     pin_text(signal_pin(port, "scl")->pin), pin_text(signal_pin(port, "sda")->pin),
                     signal_pin(port, "scl")->alternate_function);
}

std::string bus_lines(const BenchPlan& plan) {
  std::string all;
  for (const BusLine& it : plan.bus_lines) all += fmt::format("{{{}, {}}}, ", it.line, it.bus);
  return fmt::format("inline constexpr BusLine kBusLines[] = {{{}{{kNoLine, 0}}}};\n", all);
}

std::string constants(const BenchPlan& plan) {
  constexpr std::size_t kBytesOfTest = 240, kBytesAround = 1'000;
  const std::string identity = plan.identity();
  return fmt::format(
             "inline constexpr const char kBoardName[] = \"{}\", kRobotName[] = \"{}\", kPlanName[] = \"{}\";\n"
             "inline constexpr std::uint32_t kPlanNumber = 0x{};\n"
             "inline constexpr std::uint32_t kReportBaud = 115'200, kReportBusHz = {}, kReportBytes = {};\n"
             "inline constexpr Test kFirstRoutine{{{}}}, kFirstStage{{{}}};\n"
             "inline constexpr unsigned kBusCount = {}, kStageCount = {}, kFreeLine = {};\n"
             "#define FINEMOTE_BENCH_LINE finemote_line_{}\n",
             plan.board.name, plan.robot, identity, identity.substr(0, 8), *plan.board.port(kReport)->clock_hz,
             kBytesAround + kBytesOfTest * plan.tests.size(), plan.tests.size() - plan.stages - plan.buses,
             plan.tests.size() - plan.stages, plan.buses, plan.stages, plan.free_line, plan.free_line) +
         bus_lines(plan) + serial_pins(plan.board) + spi_pins(plan.board, "kSensorSpi", kImu) +
         spi_pins(plan.board, "kLoopSpi", kSpiLoop) + i2c_pins(plan.board, "kSensorI2c", kCompass);
}

}  // namespace

std::string BenchPlan::identity() const {
  constexpr std::size_t kDigits = 16;
  std::string text = board.name + "\n" + robot + "\n";
  for (const BenchTest& it : tests)
    text += fmt::format("{} {} {} {} {}\n", it.name, it.least, it.most, it.is_judged, it.needs);
  return sha256(text).substr(0, kDigits);
}

std::vector<std::string> bench_groups(const std::vector<BenchTest>& tests) {
  std::vector<std::string> groups;
  for (const BenchTest& test : tests) {
    if (std::find(groups.begin(), groups.end(), test.group) == groups.end()) groups.push_back(test.group);
  }
  return groups;
}

std::string bench_plan_header(const BenchPlan& plan) {
  const std::vector<std::string> groups = bench_groups(plan.tests);
  return fmt::format(
      "{}\n"
      "// The tests of this kit, what is expected of them, and the ports they use.\n"
      "#pragma once\n\n#include \"planned.hpp\"\n\n"
      "namespace finemote::bench_kit {{\n\n"
      "enum class Group : std::uint8_t {{\n{}}};\ninline constexpr unsigned kGroupCount = {};\n\n"
      "enum class Test : std::uint16_t {{\n{}}};\ninline constexpr unsigned kTestCount = {};\n\n"
      "inline constexpr Planned kTests[kTestCount] = {{\n{}}};\n\n{}\n}}  // namespace finemote::bench_kit\n",
      kGeneratedHeader, enumerators(groups), groups.size(), enumerators(names_of(plan.tests)), plan.tests.size(),
      lines_of_tests(plan), constants(plan));
}

}  // namespace finemote::gen
