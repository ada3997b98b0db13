#include "generator/graph/forest_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/svg/palette.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen {

// In CSS, and of pictures alone: what `.forest` holds.
const char* const kForestStyle =
    R"(.forest text { font: 13px "DejaVu Sans Mono", "Liberation Mono", Menlo, Consolas, monospace; fill: var(--ink) }
.forest .title { font-size: 16px; font-weight: bold }
.forest .name { font-weight: bold }
.forest .muted { fill: var(--muted) }
.forest .card { fill: var(--surface); stroke: var(--line) }
.forest .edge { fill: none; stroke: var(--edge); stroke-width: 1.5 }
.forest .bus-0 { fill: var(--bus-0) } .forest .bus-1 { fill: var(--bus-1) } .forest .bus-2 { fill: var(--bus-2) }
.forest .bus-3 { fill: var(--bus-3) } .forest .bus-4 { fill: var(--bus-4) } .forest .bus-5 { fill: var(--bus-5) }
.forest .bus-6 { fill: var(--bus-6) } .forest .bus-7 { fill: var(--bus-7) }
.forest .period-0 { fill: var(--period-0) } .forest .period-1 { fill: var(--period-1) }
.forest .period-2 { fill: var(--period-2) } .forest .period-3 { fill: var(--period-3) }
.forest .period-4 { fill: var(--period-4) } .forest .period-5 { fill: var(--period-5) }
)";

namespace {

// In pixels.
constexpr std::size_t kMargin = 10, kInset = 12, kGap = 8, kIndent = 20;
constexpr std::size_t kLine = 18;  ///< from one text to the next
constexpr std::size_t kCard = 42, kChip = 22, kStripe = 5;
constexpr std::size_t kNarrowest = 340;
constexpr std::size_t kTitle = 26;  ///< a character of the title is wider than others

std::string details_of(const ForestView& view, const ForestRow& row) {
  std::string text = row.type + ", " + row.period;
  for (const std::size_t read : row.reads) text += ", reads " + view.rows[read].name;
  return text;
}

std::size_t chip_width(const std::string& text) { return text.empty() ? 0 : svg::width_of(text) + 2 * kGap; }

std::size_t card_left(const ForestRow& row) { return kMargin + kIndent * row.depth; }

/// As wide as its widest line.
std::size_t width_of(const ForestView& view) {
  std::size_t width = std::max(kNarrowest, 2 * kMargin + 10 * svg::columns(view.robot));
  for (const ForestRow& row : view.rows) {
    const std::size_t words = std::max(svg::width_of(row.name), svg::width_of(details_of(view, row)));
    const std::size_t chip = row.place.empty() ? 0 : chip_width(row.place) + kGap;
    width = std::max(width, card_left(row) + kInset + words + kInset + chip + kMargin);
  }
  for (const BusRow& bus : view.buses) {
    width = std::max(width, 2 * kMargin + chip_width(bus.name) + kGap + svg::width_of(bus.what));
    for (const std::string& part : bus.behind) width = std::max(width, 2 * kMargin + 2 * kGap + svg::width_of(part));
  }
  return width;
}

std::string bus_look(std::size_t bus) { return fmt::format("chip bus-{}", bus % svg::kBusColours); }

std::string chip(std::size_t bus, const std::string& text, std::size_t x, std::size_t y) {
  return svg::rect(bus_look(bus), {x, y, chip_width(text), kChip}, kChip / 2) + svg::text("", x + kGap, y + 15, text);
}

/// What is drawn, and how far down.
struct Sheet {
  std::size_t width = 0, y = kMargin;
  std::string body = {};
};

void draw_title(const ForestView& view, Sheet& sheet) {
  sheet.body += svg::text("title", kMargin, sheet.y + 15, view.robot);
  sheet.y += kTitle;
  sheet.body += svg::text("muted", kMargin, sheet.y + 13, fmt::format("{}, tick {}", view.board, view.tick));
  sheet.y += kLine + kGap;
}

void draw_buses(const ForestView& view, Sheet& sheet) {
  for (std::size_t bus = 0; bus < view.buses.size(); ++bus) {
    const BusRow& row = view.buses[bus];
    sheet.body += chip(bus, row.name, kMargin, sheet.y);
    sheet.body += svg::text("muted", kMargin + chip_width(row.name) + kGap, sheet.y + 15, row.what);
    sheet.y += kChip + kGap / 2;
    for (const std::string& part : row.behind) {
      sheet.body += svg::text("muted", kMargin + 2 * kGap, sheet.y + 13, part);
      sheet.y += kLine;
    }
  }
  sheet.y += kGap;
}

void draw_card(const ForestView& view, const ForestRow& row, Sheet& sheet) {
  const std::size_t x = card_left(row);
  sheet.body += fmt::format("<g class=\"device\" data-device=\"{}\">\n", svg::escaped(row.name));
  sheet.body += svg::rect("card", {x, sheet.y, sheet.width - kMargin - x, kCard}, 4);
  sheet.body += svg::rect(fmt::format("period-{}", row.bucket % svg::kPeriodColours), {x, sheet.y, kStripe, kCard}, 2);
  sheet.body += svg::text("name", x + kInset, sheet.y + 17, row.name);
  sheet.body += svg::text("muted", x + kInset, sheet.y + 34, details_of(view, row));
  if (!row.place.empty()) {
    const std::size_t left = sheet.width - kMargin - kGap - chip_width(row.place);
    sheet.body += chip(*row.bus, row.place, left, sheet.y + (kCard - kChip) / 2);
  }
  sheet.body += "</g>\n";
}

void draw_trees(const ForestView& view, Sheet& sheet) {
  std::vector<std::size_t> top;  // of every row's card
  for (const ForestRow& row : view.rows) {
    if (row.depth == 0 && !top.empty()) sheet.y += kGap;
    top.push_back(sheet.y);
    if (row.parent) {
      const std::size_t x = card_left(view.rows[*row.parent]) + kIndent / 2;
      sheet.body += fmt::format("<path class=\"edge\" d=\"M{} {}V{}H{}\"/>\n", x, top[*row.parent] + kCard,
                                sheet.y + kCard / 2, card_left(row));
    }
    draw_card(view, row, sheet);
    sheet.y += kCard + kGap;
  }
  sheet.y += kMargin - kGap;
}

Sheet drawn(const ForestView& view) {
  Sheet sheet{width_of(view)};
  draw_title(view, sheet);
  draw_buses(view, sheet);
  draw_trees(view, sheet);
  return sheet;
}

}  // namespace

std::string forest_svg(const ForestView& view) {
  const Sheet sheet = drawn(view);
  const std::string style = fmt::format(
      "svg {{\n{}}}\n@media (prefers-color-scheme: dark) {{\nsvg {{\n{}}}\n}}\n.page {{ fill: var(--page) }}\n{}",
      svg::kLightColours, svg::kDarkColours, kForestStyle);
  const std::string body =
      svg::rect("page", {0, 0, sheet.width, sheet.y}, 6) + "<g class=\"forest\">\n" + sheet.body + "</g>\n";
  return svg::picture(sheet.width, sheet.y, "Device trees of " + view.robot, style, body);
}

std::string inline_forest_svg(const ForestView& view) {
  const Sheet sheet = drawn(view);
  return fmt::format(
      "<svg class=\"forest\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"group\" "
      "aria-label=\"Device trees\">\n{2}</svg>\n",
      sheet.width, sheet.y, sheet.body);
}

}  // namespace finemote::gen
