#include "generator/document/board_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/document/markdown.hpp"
#include "generator/document/param_table.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

const Json& list(const Json& value, const char* key) {
  static const Json none = Json::array();
  const auto found = value.find(key);
  return found == value.end() || found->is_null() ? none : *found;
}

std::vector<std::string> texts(const Json& values) {
  std::vector<std::string> result;
  for (const Json& value : values) result.push_back(value.get<std::string>());
  return result;
}

std::string pins_text(const Json& port) {
  std::vector<std::string> parts;
  for (const Json& pin : list(port, "pins"))
    parts.push_back(fmt::format("{} {} (alternate function {})", pin["signal"].get<std::string>(),
                                pin["pin"].get<std::string>(), pin["af"].get<int>()));
  return joined(parts);
}

std::string dma_text(const Json& port) {
  std::vector<std::string> parts;
  for (const Json& dma : list(port, "dma"))
    parts.push_back(fmt::format("{} {} stream {} channel {}", dma["signal"].get<std::string>(),
                                dma["controller"].get<std::string>(), dma["stream"].get<int>(),
                                dma["channel"].get<int>()));
  return joined(parts);
}

std::string lines_text(const Json& port) {
  std::vector<std::string> parts;
  for (const Json& line : list(port, "interrupts"))
    parts.push_back(fmt::format("{} ({})", line["name"].get<std::string>(), line["line"].get<int>()));
  return joined(parts);
}

std::string rate_text(const Json& port, const std::string& bus) {
  if (bus == "pwm") return "pulses repeat every " + time_text(port.value("period_ns", std::int64_t{20'000'000}));
  if (bus == "gpio") return "none";
  const char* unit = bus == "i2c" || bus == "spi" ? "Hz" : "bit/s";
  std::vector<std::string> rates;
  for (const Json& rate : list(port, "rates")) rates.push_back(rate.dump());
  std::string text = rates.empty() ? fmt::format("{} to {} {}", port["min_rate"].dump(), port["max_rate"].dump(), unit)
                                   : joined(rates) + " " + unit;
  if (port.contains("max_rate_error_ppm"))
    text += fmt::format(", made within {} %", static_cast<double>(port["max_rate_error_ppm"].get<int>()) / 1e4);
  return text;
}

/// A bus tag with the attribute that its kind asks for.
std::string example(const Json& port, const std::string& bus) {
  const std::string rate = bus == "uart" || bus == "rs485" ? " baud=\"115200baud\""
                           : bus == "can"                  ? " bitrate=\"1Mbit/s\""
                           : bus == "i2c"                  ? " clock=\"400kHz\""
                           : bus == "spi"                  ? " clock=\"5250kHz\""
                                                           : "";
  return fmt::format("<bus name=\"my_bus\" type=\"{}\" port=\"{}\"{}/>\n", bus, port["name"].get<std::string>(), rate);
}

BoardPage port_page(const Json& board, const Json& port) {
  const std::string name = port["name"].get<std::string>();
  const std::vector<std::string> buses = texts(port["buses"]);
  std::string text = sentence(port["connector"].get<std::string>()) + "\n\n" + table({"", ""});
  text += row({"serves", joined(buses)});
  std::vector<std::string> labels;
  for (const std::string& label : texts(list(port, "silkscreen"))) labels.push_back("`" + label + "`");
  text += row({"printed labels (not port names)", joined(labels)});
  text += row({"pins", pins_text(port)});
  if (port.contains("timer"))
    text += row({"timer", fmt::format("{} channel {}", port["timer"]["name"].get<std::string>(),
                                      port["timer"]["channel"].get<int>())});
  text += row({"DMA", dma_text(port)});
  if (port.value("inverter", false))
    text += row({"line", "inverted by the board: for inverted formats, and only those"});
  if (port.contains("channels") && buses.front() == "spi")
    text += row({"chip selects", port.contains("selects") ? joined(texts(port["selects"])) : port["channels"].dump()});
  text += row({"interrupt lines", lines_text(port)});
  text += row({"clock", port["clock_hz"].dump() + " Hz"});
  text += row({"rates", rate_text(port, buses.front())});
  for (const std::string& bus : buses) {
    const Json& driver = board.at("drivers").at(bus);
    text += row({fmt::format("driver `{}`", bus),
                 fmt::format("{}{}; an interrupt takes at most {}", driver["summary"].get<std::string>(),
                             driver.value("assumed", false) ? " (assumed)" : "",
                             time_text(driver["isr_wcet_ns"].get<std::int64_t>()))});
  }
  text += "\n```xml\n";
  for (const std::string& bus : buses) text += example(port, bus);
  return {name, fmt::format("`{}`: {}", name, port["connector"].get<std::string>()), text + "```\n"};
}

std::string connector_table(const Json& board) {
  if (list(board, "connectors").empty()) return {};
  std::string text =
      "\n## On connectors\n\nPins of a port are free where no bus uses the port. lint reports pins that lead "
      "nowhere.\n\n" +
      table({"connector", "pins"});
  for (const Json& connector : list(board, "connectors"))
    text += row({connector["name"].get<std::string>(), joined(texts(connector["pins"]))});
  return text;
}

std::string reserved_table(const Json& board) {
  if (list(board, "reserved_pins").empty()) return {};
  std::string text =
      "\n## Reserved\n\nThe board needs these itself; a device that names one is refused "
      "([FM3206](../../../diagnostics/FM3206.md)).\nAny device may listen to a data-ready line whose name is above as "
      "an "
      "interrupt.\n\n" +
      table({"pins", "for", "usable by"});
  for (const Json& reserved : list(board, "reserved_pins")) {
    const std::string port = reserved.value("port", "");
    text += row({joined(texts(reserved["pins"])), reserved["for"].get<std::string>(),
                 port.empty() ? "nobody" : fmt::format("devices on a bus at `{}`", port)});
  }
  return text;
}

BoardPage pins_page(const Json& board) {
  std::string text =
      "Pins with a name. A device uses one as `<use role=\"...\" pin=\"key\"/>`; any other pin of the chip that is not "
      "reserved can be an\n"
      "input or an output by its own name, `pin=\"PB12\"`.\n\n" +
      table({"name", "pin", "can be", "active", "what"});
  for (const Json& pin : list(board, "pins")) {
    std::string what = pin["summary"].get<std::string>();
    if (pin.contains("analog"))
      what += fmt::format("; full scale {} mV at {} input {}", pin["analog"]["full_scale_mv"].dump(),
                          pin["analog"]["converter"].get<std::string>(), pin["analog"]["input"].dump());
    text += row({"`" + pin["name"].get<std::string>() + "`", pin["pin"].get<std::string>(),
                 joined(texts(pin["functions"])), pin["active"].get<std::string>(), what});
  }
  return {"pins", "Single pins", text + connector_table(board) + reserved_table(board)};
}

}  // namespace

std::vector<BoardPage> board_pages(const Json& board) {
  std::vector<BoardPage> pages;
  std::string index = sentence(board["summary"].get<std::string>()) + "\n\n" + table({"port", "serves", "connector"});
  for (const Json& port : board["ports"]) {
    const std::string name = port["name"].get<std::string>();
    index += row(
        {fmt::format("[`{}`]({}.md)", name, name), joined(texts(port["buses"])), port["connector"].get<std::string>()});
    pages.push_back(port_page(board, port));
  }
  index += "\n[Single pins](pins.md): key, battery, LEDs and what else has a name.\n" + param_table(board);
  pages.push_back(pins_page(board));
  pages.insert(pages.begin(), {"README", "Peripherals of `" + board["name"].get<std::string>() + "`", index});
  return pages;
}

}  // namespace finemote::gen
