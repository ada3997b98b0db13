#include "generator/bench_kit/jumpers.hpp"

#include <fmt/format.h>

#include "generator/bench_kit/bench_ports.hpp"
#include "generator/descriptor/port_signals.hpp"

namespace finemote::gen {
namespace {

Jumper jumper(const Board& board, const char* name, const char* port_name, const char* from, const char* to) {
  const Port& port = *board.port(port_name);
  return {name, port.name, port.connector, from, signal_pin(port, from)->pin, to, signal_pin(port, to)->pin};
}

/// One connector with its two pins, `y` below the top.
std::string drawing_of(const Jumper& it, int y) {
  return fmt::format(
      "  <text x=\"20\" y=\"{0}\" font-weight=\"bold\">{1}: {2}</text>\n"
      "  <rect x=\"20\" y=\"{3}\" width=\"280\" height=\"60\" fill=\"none\" stroke=\"black\"/>\n"
      "  <circle cx=\"80\" cy=\"{4}\" r=\"6\"/>\n"
      "  <circle cx=\"240\" cy=\"{4}\" r=\"6\"/>\n"
      "  <path d=\"M80 {4} C80 {5} 240 {5} 240 {4}\" fill=\"none\" stroke=\"firebrick\" stroke-width=\"3\"/>\n"
      "  <text x=\"80\" y=\"{6}\" text-anchor=\"middle\">{7} ({8})</text>\n"
      "  <text x=\"240\" y=\"{6}\" text-anchor=\"middle\">{9} ({10})</text>\n",
      y + 20, it.name, it.connector, y + 32, y + 50, y + 90, y + 76, it.from, it.from_pin, it.to, it.to_pin);
}

}  // namespace

std::vector<Jumper> bench_jumpers(const Board& board) {
  using namespace bench_ports;
  return {jumper(board, kSerialJumper, kSerialLoop, "tx", "rx"), jumper(board, kSpiJumper, kSpiLoop, "mosi", "miso")};
}

std::string jumper_drawing(const std::vector<Jumper>& jumpers) {
  constexpr int kHeight = 120;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"420\" height=\"{}\" font-family=\"sans-serif\" "
      "font-size=\"13\">\n",
      kHeight * static_cast<int>(jumpers.size()));
  int y = 0;
  for (const Jumper& it : jumpers) {
    text += drawing_of(it, y);
    y += kHeight;
  }
  return text + "</svg>\n";
}

nlohmann::ordered_json jumper_scenario(const std::vector<Jumper>& jumpers) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const Jumper& it : jumpers)
    parts.push_back({{"name", it.name}, {"type", it.from == "tx" ? "serial_jumper" : "spi_jumper"}, {"port", it.port}});
  return {{"schema", "finemote.scenario/1"}, {"parts", parts}};
}

}  // namespace finemote::gen
