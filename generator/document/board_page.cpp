#include "generator/document/board_page.hpp"

#include <fmt/format.h>

#include "generator/bus/bus_type.hpp"
#include "generator/document/connector_page.hpp"
#include "generator/document/markdown.hpp"
#include "generator/document/param_table.hpp"

namespace finemote::gen {
namespace {

std::string pins_text(const Port& port) {
  std::vector<std::string> parts;
  for (const PortPin& pin : port.pins)
    parts.push_back(fmt::format("{} {} (alternate function {})", pin.signal, pin.pin, pin.alternate_function));
  return joined(parts);
}

std::string dma_text(const Port& port) {
  std::vector<std::string> parts;
  for (const DmaStream& dma : port.dma)
    parts.push_back(fmt::format("{} {} stream {} channel {}", dma.signal, dma.controller, dma.stream, dma.channel));
  return joined(parts);
}

std::string lines_text(const Port& port) {
  std::vector<std::string> parts;
  for (const InterruptLine& line : port.interrupts) parts.push_back(fmt::format("{} ({})", line.name, line.number));
  return joined(parts);
}

std::string rate_range(const Port& port, const RateForm& form) {
  if (!port.rates.empty()) return fmt::format("{} {}", fmt::join(port.rates, ", "), form.page_unit);
  return fmt::format("{} to {} {}", port.min_rate.value_or(0), port.max_rate.value_or(0), form.page_unit);
}

std::string rates_text(const Port& port) {
  const BusType& type = bus_type(port.kinds.front());
  if (type.channels == BusType::Channels::outputs) return "pulses repeat every " + time_text(port.period);
  const RateForm* form = type.rate.form;
  if (form == nullptr) return "none";
  if (!form->has_tolerance) return rate_range(port, *form);
  return fmt::format("{}, made within {} %", rate_range(port, *form),
                     static_cast<double>(port.max_rate_error_ppm) / 1e4);
}

/// A bus tag with the attribute that its kind asks for.
std::string example(const Port& port, BusKind kind) {
  const BusRate& rate = bus_type(kind).rate;
  const std::string written =
      rate.form != nullptr ? fmt::format(" {}=\"{}\"", rate.form->attribute, rate_text(kind, rate.example)) : "";
  return fmt::format("<bus name=\"my_bus\" type=\"{}\" port=\"{}\"{}/>\n", bus_kind_name(kind), port.name, written);
}

/// How long one run of its routine takes.
std::string source_text(const DriverSource& source) {
  std::string text = fmt::format("`{}` {}", source.name, time_text(source.isr_wcet));
  if (source.isr_per_slot > Duration::zero())
    text += " and " + time_text(source.isr_per_slot) + " for each device on the bus";
  if (source.isr_per_frame > Duration::zero())
    text += " and " + time_text(source.isr_per_frame) + " for each frame of a request";
  if (source.isr_waits_bits > 0)
    text += fmt::format(", or {} bit{} of the bus and {}, whichever is longer", source.isr_waits_bits,
                        source.isr_waits_bits == 1 ? "" : "s",
                        source.isr_beside_wait ? time_text(*source.isr_beside_wait) : "all of it");
  return text;
}

std::string driver_row(const Driver& driver, BusKind kind) {
  std::vector<std::string> interrupts;
  for (const DriverSource& source : driver.sources) interrupts.push_back(source_text(source));
  std::string text = driver.summary + (driver.is_assumed ? " (assumed)" : "");
  if (!interrupts.empty()) text += "; interrupts take at most: " + joined(interrupts);
  return row({fmt::format("driver `{}`", bus_kind_name(kind)), text});
}

BoardPage port_page(const Board& board, const Port& port) {
  const BusKind kind = port.kinds.front();
  std::string text = sentence(port.connector) + "\n\n" + table({"", ""});
  text += row({"serves", joined(bus_kind_names(port.kinds))});
  std::vector<std::string> labels;
  for (const std::string& label : port.silkscreen) labels.push_back("`" + label + "`");
  text += row({"printed labels (not port names)", joined(labels)});
  text += row({"pins", pins_text(port)});
  if (port.timer) text += row({"timer", fmt::format("{} channel {}", port.timer->timer, port.timer->channel)});
  text += row({"DMA", dma_text(port)});
  if (port.has_inverter) text += row({"line", "inverted by the board: for inverted formats, and only those"});
  if (port.channels > 0 && bus_type(kind).channels == BusType::Channels::selects)
    text += row({"chip selects", port.selects.empty() ? std::to_string(port.channels) : joined(port.selects)});
  text += row({"interrupt lines", lines_text(port)});
  text += row({"clock", fmt::format("{} Hz", port.clock_hz.value_or(0))});
  text += row({"rates", rates_text(port)});
  for (const BusKind each : port.kinds) text += driver_row(board.drivers.at(each), each);
  text += "\n```xml\n";
  for (const BusKind each : port.kinds) text += example(port, each);
  return {port.name, fmt::format("`{}`: {}", port.name, port.connector), text + "```\n"};
}

std::string reserved_table(const Board& board) {
  if (board.reserved_pins.empty()) return {};
  std::string text =
      "\n## Reserved\n\nThe board needs these itself; a device that names one is refused "
      "([FM3206](../../../diagnostics/FM3206.md)).\nAny device may listen to a data-ready line whose name is above as "
      "an "
      "interrupt.\n\n" +
      table({"pins", "for", "usable by"});
  for (const ReservedPins& reserved : board.reserved_pins) {
    text += row({joined(reserved.pins), reserved.purpose,
                 reserved.port.empty() ? "nobody" : fmt::format("devices on a bus at `{}`", reserved.port)});
  }
  return text;
}

BoardPage pins_page(const Board& board) {
  std::string text =
      "Pins with a name. A device uses one as `<use role=\"...\" pin=\"key\"/>`; any other pin of the chip that is not "
      "reserved can be an\n"
      "input or an output by its own name, `pin=\"PB12\"`. [Connectors](connectors.md) shows which contact it leads "
      "to; lint\n"
      "reports pins that lead nowhere.\n\n" +
      table({"name", "pin", "can be", "active", "what"});
  for (const NamedPin& pin : board.pins) {
    std::string what = pin.summary;
    if (!pin.converter.empty())
      what += fmt::format("; full scale {} mV at {} input {}", pin.full_scale_mv, pin.converter, pin.input);
    text += row({"`" + pin.name + "`", pin.pin, joined(pin.functions), pin.active_low ? "low" : "high", what});
  }
  return {"pins", "Single pins", text + reserved_table(board)};
}

}  // namespace

std::vector<BoardPage> board_pages(const Board& board) {
  std::vector<BoardPage> pages;
  std::string index = sentence(board.summary) + "\n\n" + table({"port", "serves", "connector"});
  for (const Port& port : board.ports) {
    index += row({fmt::format("[`{0}`]({0}.md)", port.name), joined(bus_kind_names(port.kinds)), port.connector});
    pages.push_back(port_page(board, port));
  }
  index +=
      "\n[Connectors](connectors.md): pictures of the contacts, and what each can be used for. [Single pins](pins.md): "
      "key,\nbattery, LEDs and what else has a name.\n" +
      param_table(board.params);
  pages.push_back({"connectors", "Connectors of `" + board.name + "`", connector_page(board)});
  pages.push_back(pins_page(board));
  pages.insert(pages.begin(), {"README", "Peripherals of `" + board.name + "`", index});
  return pages;
}

}  // namespace finemote::gen
