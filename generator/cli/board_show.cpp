// finemote board show: what a board offers, so that nobody has to guess which connector is which port.
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/descriptor/bus_kind.hpp"
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

void print_board(Context& context, const Board& board) {
  context.out << fmt::format("{}: {}\n", board.name, board.summary);
  context.out << fmt::format("\n{:<8} {:<12} {:<24} {:<34} {:<28} {}\n", "port", "serves", "pins", "DMA", "interrupts",
                             "connector");
  for (const Port& port : board.ports) {
    context.out << fmt::format("{:<8} {:<12} {:<24} {:<34} {:<28} {}\n", port.name, joined(bus_kind_names(port.kinds)),
                               joined(pin_names(port)), joined(stream_names(port)), joined(line_texts(port)),
                               port.connector);
  }
  std::vector<std::string> lines;
  for (const SpareLine& line : board.lines) lines.push_back(fmt::format("{} ({})", line.number, line.name));
  if (!board.connectors.empty()) context.out << "\npins on connectors\n";
  for (const Connector& connector : board.connectors)
    context.out << fmt::format("  {:<38} {}\n", connector.name, joined(connector.pins));
  if (!board.reserved_pins.empty()) context.out << "\nreserved pins\n";
  for (const ReservedPins& reserved : board.reserved_pins)
    context.out << fmt::format("  {:<38} {}\n", joined(reserved.pins), reserved.purpose);
  context.out << fmt::format("\nperiod buckets: priority levels {} to {}, interrupt lines {}\n",
                             board.first_bucket_level, board.last_bucket_level, joined(lines));
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

}  // namespace

int run_board_show(Context& context) {
  const std::string data_dir = find_data_dir(context.options, context.diagnostics);
  if (data_dir.empty()) return finish(context, kExitInvalid);
  auto library = load_library({data_dir, "", {}, {}}, context.sources, context.diagnostics);
  if (!library) return finish(context, kExitInvalid);
  const std::vector<std::string> names = board_names(*library);
  if (context.options.input.empty()) {
    if (context.options.format == Format::text) {
      for (const std::string& name : names) context.out << name << "\n";
    }
    return finish(context, kExitYes, Json{{"schema", "finemote.boards/1"}, {"boards", names}});
  }
  const Board* board = find_board(*library, context.options.input, context.sources, context.diagnostics);
  if (board == nullptr) {
    if (!context.diagnostics.has_errors()) {
      context.diagnostics.error(code::usage, {}, fmt::format("there is no board '{}'", context.options.input))
          .hint(did_you_mean(context.options.input, names));
    }
    return finish(context, kExitInvalid);
  }
  if (context.options.format == Format::text) print_board(context, *board);
  Json document{{"schema", "finemote.board-view/1"}};
  document.update(to_json(*board));
  return finish(context, kExitYes, document);
}

}  // namespace finemote::gen
