#include "generator/document/connector_picture.hpp"

#include <algorithm>

#include "generator/document/contact_use.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen {
namespace {

// In pixels.
constexpr std::size_t kInset = 8, kGap = 4, kMargin = 10;
constexpr std::size_t kTwoLines = 42, kOneLine = 26, kNarrowest = 56;

constexpr const char* kStyle =
    R"(text { font: 13px "DejaVu Sans Mono", "Liberation Mono", Menlo, Consolas, monospace; fill: #1f2328 }
.name { font-weight: bold }
rect { stroke: #59636e; fill: #f6f8fa }
.body { fill: #ffffff; stroke-width: 2 }
.ground { fill: #d0d7de }
.supply { fill: #ffd8d3 }
.bus { fill: #cfe8ff }
.pin { fill: #d3f5d9 }
@media (prefers-color-scheme: dark) {
text { fill: #f0f6fc }
rect { stroke: #9198a1; fill: #212830 }
.body { fill: #0d1117 }
.ground { fill: #3d444d }
.supply { fill: #67201b }
.bus { fill: #0c3b6b }
.pin { fill: #11532a }
}
)";

/// What stands in the box of a contact.
struct Box {
  std::string name;      ///< `7 SPI2_MISO`
  std::string leads_to;  ///< `PB14 spi2`; may be empty
  const char* look = "other";
};

std::string leads_to(const Contact& contact, const ContactUse& use) {
  std::string text = contact.pin == contact.name ? "" : contact.pin;
  const auto add = [&](const std::string& word) {
    if (text.find(word) == std::string::npos) text += (text.empty() ? "" : " ") + word;
  };
  for (const PortUse& port : use.ports) add(port.port->name);
  if (!use.ports.empty()) return text;
  if (use.named != nullptr) add(use.named->name);
  if (use.reserved != nullptr && use.named == nullptr) add("reserved");
  return text;
}

const char* look(const Contact& contact, const ContactUse& use) {
  if (contact.volts) return *contact.volts > 0 ? "supply" : "ground";
  if (!use.ports.empty()) return "bus";
  return contact.pin.empty() || use.reserved != nullptr ? "other" : "pin";
}

Box box_of(const Contact& contact, const Board& board) {
  const ContactUse use = use_of(contact, board);
  return {contact.number + " " + contact.name, leads_to(contact, use), look(contact, use)};
}

std::vector<std::vector<Box>> boxes_of(const Connector& connector, const Board& board) {
  std::vector<std::vector<Box>> lines;
  for (const auto& contacts : connector.lines) {
    std::vector<Box>& line = lines.emplace_back();
    for (const Contact& contact : contacts) line.push_back(box_of(contact, board));
  }
  return lines;
}

/// Of every column, its widest text with what surrounds it.
std::vector<std::size_t> widths_of(const std::vector<std::vector<Box>>& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()), kNarrowest);
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::size_t longest = std::max(svg::width_of(line[i].name), svg::width_of(line[i].leads_to));
      widths[i] = std::max(widths[i], 2 * kInset + longest);
    }
  }
  return widths;
}

std::size_t height_of(const std::vector<Box>& line) {
  const bool has_second = std::any_of(line.begin(), line.end(), [](const Box& box) { return !box.leads_to.empty(); });
  return has_second ? kTwoLines : kOneLine;
}

std::string drawn(const Box& box, std::size_t x, std::size_t y, std::size_t width, std::size_t height) {
  const std::size_t first = box.leads_to.empty() ? y + height / 2 + 5 : y + 17;
  std::string text = svg::rect(box.look, {x, y, width, height}, 3) + svg::text("name", x + kInset, first, box.name);
  if (!box.leads_to.empty()) text += svg::text("", x + kInset, y + 34, box.leads_to);
  return text;
}

}  // namespace

std::string connector_picture(const Connector& connector, const Board& board) {
  const auto lines = boxes_of(connector, board);
  const auto widths = widths_of(lines);
  std::string boxes;
  std::size_t y = kMargin;
  for (const auto& line : lines) {
    std::size_t x = kMargin;
    for (std::size_t i = 0; i < line.size(); ++i) {
      boxes += drawn(line[i], x, y, widths[i], height_of(line));
      x += widths[i] + kGap;
    }
    y += height_of(line) + kGap;
  }
  std::size_t width = 2 * kMargin - kGap;
  for (const std::size_t column : widths) width += column + kGap;
  const std::size_t height = y - kGap + kMargin;
  const std::string body = svg::rect("body", {1, 1, width - 2, height - 2}, 6);
  return svg::picture(width, height, connector.name, kStyle, body + boxes);
}

}  // namespace finemote::gen
