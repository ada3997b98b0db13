#include "generator/document/connector_page.hpp"

#include <fmt/format.h>

#include <cctype>

#include "generator/document/connector_picture.hpp"
#include "generator/document/contact_use.hpp"
#include "generator/document/markdown.hpp"

namespace finemote::gen {
namespace {

/// The connector's name in letters of a file's name.
std::string picture_name(const Connector& connector) {
  std::string name;
  for (const char c : connector.name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_plain) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!is_plain && !name.empty() && name.back() != '_') name += '_';
  }
  return name + ".svg";
}

/// The buses of a port, and what the contact is to them: `usart1` (uart, rs485): rx.
std::string bus_text(const ContactUse& use) {
  std::vector<std::string> texts;
  for (const PortUse& each : use.ports) {
    const std::string port =
        fmt::format("[`{0}`]({0}.md) ({1})", each.port->name, joined(bus_kind_names(each.port->kinds)));
    texts.push_back(each.signal.empty() ? port : port + ": " + each.signal);
  }
  return joined(texts, "; ", "");
}

std::string pin_text(const Contact& contact, const ContactUse& use) {
  if (contact.pin.empty()) return "";
  const std::string functions = use.named != nullptr ? joined(use.named->functions) : "input, output";
  const std::string name = use.named != nullptr ? use.named->name : contact.pin;
  if (use.reserved == nullptr) return fmt::format("`pin=\"{}\"`: {}", name, functions);
  const std::string port =
      use.reserved->port.empty() ? "" : fmt::format("; devices at `{}` may use it", use.reserved->port);
  return "reserved for " + use.reserved->purpose + port;
}

std::string contact_table(const Connector& connector, const Board& board) {
  std::string text = table({"contact", "name", "pin", "as part of a bus", "by itself"});
  for (const auto& line : connector.lines) {
    for (const Contact& contact : line) {
      if (contact.pin.empty() && contact.port.empty()) continue;
      const ContactUse use = use_of(contact, board);
      text += row({contact.number, contact.name, contact.pin, bus_text(use), pin_text(contact, use)});
    }
  }
  return text;
}

std::string section(const Connector& connector, const Board& board) {
  std::string text = "\n## " + sentence(connector.name);
  text.back() = '\n';
  if (!connector.remark.empty()) text += "\n" + connector.remark + "\n";
  if (connector.lines.empty())
    return text + "\nLeads to " + joined(connector.pins) + "; the order of its contacts is not known.\n";
  text += fmt::format("\n![{}]({})\n\n", "contacts of the " + connector.name, picture_name(connector));
  return text + contact_table(connector, board);
}

}  // namespace

std::vector<Picture> connector_pictures(const Board& board) {
  std::vector<Picture> pictures;
  for (const Connector& connector : board.connectors) {
    if (!connector.lines.empty()) pictures.push_back({picture_name(connector), connector_picture(connector, board)});
  }
  return pictures;
}

std::string connector_page(const Board& board) {
  std::string text =
      "The numbers are those of the board's manual. The pictures show which contacts lie side by side, not where on "
      "the\n"
      "board a connector is or how it is turned; look for its contact 1 there. Blue is a contact of a bus, green a pin "
      "to\n"
      "be used by itself, red a supply, grey ground. A pin of a bus is free for other uses where the robot has no bus "
      "on "
      "that\nport.\n";
  for (const Connector& connector : board.connectors) text += section(connector, board);
  return text;
}

}  // namespace finemote::gen
