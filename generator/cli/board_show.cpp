// finemote board show: what a board offers, so that nobody has to guess which connector is which port.
#include <fmt/format.h>

#include "generator/bus/bus_kind.hpp"
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "-" : text;
}

std::vector<std::string> pin_names(const Port& port) {
  std::vector<std::string> names;
  for (const PortPin& pin : port.pins) names.push_back(pin.pin);
  names.insert(names.end(), port.selects.begin(), port.selects.end());
  return names;
}

std::vector<std::string> stream_names(const Port& port) {
  std::vector<std::string> names;
  for (const DmaStream& stream : port.dma) names.push_back(stream.name());
  return names;
}

std::vector<std::string> line_texts(const Port& port) {
  std::vector<std::string> texts;
  for (const InterruptLine& line : port.interrupts) texts.push_back(line.text());
  return texts;
}

/// `RXD PB7`, `CANH can1`, `PC1`: those that a robot can use.
std::vector<std::string> contact_texts(const Connector& connector) {
  if (connector.lines.empty()) return connector.pins;
  std::vector<std::string> texts;
  for (const auto& line : connector.lines) {
    for (const Contact& contact : line) {
      const std::string& leads_to = contact.pin.empty() ? contact.port : contact.pin;
      if (!leads_to.empty()) texts.push_back(contact.name == leads_to ? leads_to : contact.name + " " + leads_to);
    }
  }
  return texts;
}

std::string board_text(const Board& board) {
  std::string text;
  text += fmt::format("{}: {}\n", board.name, board.summary);
  text += fmt::format("\n{:<8} {:<12} {:<24} {:<34} {:<28} {}\n", "port", "serves", "pins", "DMA", "interrupts",
                      "connector");
  for (const Port& port : board.ports) {
    text += fmt::format("{:<8} {:<12} {:<24} {:<34} {:<28} {}\n", port.name, joined(bus_kind_names(port.kinds)),
                        joined(pin_names(port)), joined(stream_names(port)), joined(line_texts(port)), port.connector);
  }
  std::vector<std::string> lines;
  for (const SpareLine& line : board.lines) lines.push_back(fmt::format("{} ({})", line.number, line.name));
  if (!board.connectors.empty()) text += "\nconnectors\n";
  for (const Connector& connector : board.connectors)
    text += fmt::format("  {:<38} {}\n", connector.name, joined(contact_texts(connector)));
  if (!board.reserved_pins.empty()) text += "\nreserved pins\n";
  for (const ReservedPins& reserved : board.reserved_pins)
    text += fmt::format("  {:<38} {}\n", joined(reserved.pins), reserved.purpose);
  text += fmt::format("\nperiod buckets: priority levels {} to {}, interrupt lines {}\n", board.first_bucket_level,
                      board.last_bucket_level, joined(lines));
  return text;
}

Json to_json(const Board& board) {
  Json ports = Json::array();
  for (const Port& port : board.ports) {
    ports.push_back({{"name", port.name},
                     {"silkscreen", port.silkscreen},
                     {"connector", port.connector},
                     {"serves", bus_kind_names(port.kinds)},
                     {"pins", pin_names(port)},
                     {"dma", stream_names(port)},
                     {"interrupts", line_texts(port)}});
  }
  Json connectors = Json::array();
  for (const Connector& connector : board.connectors)
    connectors.push_back({{"name", connector.name}, {"pins", connector.pins}});
  Json reserved = Json::array();
  for (const ReservedPins& pins : board.reserved_pins)
    reserved.push_back({{"pins", pins.pins}, {"for", pins.purpose}, {"port", pins.port}});
  Json lines = Json::array();
  for (const SpareLine& line : board.lines) lines.push_back({{"line", line.number}, {"name", line.name}});
  return Json{{"name", board.name},       {"summary", board.summary},
              {"cpu_hz", board.cpu_hz},   {"ports", ports},
              {"connectors", connectors}, {"reserved_pins", reserved},
              {"bucket_lines", lines},    {"bucket_levels", {board.first_bucket_level, board.last_bucket_level}}};
}

Answer list_boards(const std::vector<std::string>& names) {
  Answer answer{kExitYes};
  for (const std::string& name : names) answer.text += name + "\n";
  answer.document = {{"schema", "finemote.boards/1"}, {"boards", names}};
  return answer;
}

}  // namespace

Answer run_board_show(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  auto library = load_library({data_dir, "", {}, {}}, sources, diagnostics);
  if (!library) return no_answer();
  const std::vector<std::string> names = board_names(*library);
  if (options.input.empty()) return list_boards(names);
  const Board* board = find_board(*library, options.input, sources, diagnostics);
  if (board == nullptr) {
    if (!diagnostics.has_errors()) {
      diagnostics.error(code::usage, {}, fmt::format("there is no board '{}'", options.input))
          .hint(did_you_mean(options.input, names));
    }
    return no_answer();
  }
  Answer answer{kExitYes, board_text(*board), Json{{"schema", "finemote.board-view/1"}}};
  answer.document.update(to_json(*board));
  return answer;
}

}  // namespace finemote::gen
