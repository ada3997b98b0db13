#include "generator/graph/forest_text.hpp"

#include <fmt/format.h>

namespace finemote::gen {
namespace {

std::string dot_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + "\"";
}

/// Mermaid takes entities for what its texts cannot hold as it is; numbers are between `#` and `;`.
std::string mermaid_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const bool is_plain = c != '"' && c != '#' && c != '<' && c != '>' && c != '&' && c != '`' && c != '\\';
    out += is_plain ? std::string(1, c) : fmt::format("#{};", static_cast<int>(c));
  }
  return out + "\"";
}

/// As lines: type and period, then its place.
std::vector<std::string> lines_of(const ForestRow& row) {
  std::vector<std::string> lines{row.name, row.type + ", " + row.period};
  if (!row.place.empty()) lines.push_back(row.place);
  return lines;
}

std::vector<std::string> lines_of(const BusRow& bus) {
  std::vector<std::string> lines{bus.name, bus.what};
  lines.insert(lines.end(), bus.behind.begin(), bus.behind.end());
  return lines;
}

/// Quoted lines with `between` between them, which is not escaped.
std::string joined(const std::vector<std::string>& lines, std::string_view between,
                   std::string (*quoted)(const std::string&)) {
  std::string text;
  for (const std::string& line : lines) {
    const std::string inside = quoted(line);
    text += (text.empty() ? "" : std::string(between)) + inside.substr(1, inside.size() - 2);
  }
  return "\"" + text + "\"";
}

}  // namespace

std::string forest_dot(const ForestView& view) {
  std::string text =
      fmt::format("digraph {} {{\n  rankdir=LR\n  node [shape=box, fontname=\"sans-serif\"]\n", dot_quoted(view.robot));
  for (std::size_t i = 0; i < view.rows.size(); ++i)
    text += fmt::format("  d{} [label={}]\n", i, joined(lines_of(view.rows[i]), "\\n", dot_quoted));
  for (std::size_t i = 0; i < view.buses.size(); ++i)
    text += fmt::format("  b{} [shape=ellipse, label={}]\n", i, joined(lines_of(view.buses[i]), "\\n", dot_quoted));
  for (std::size_t i = 0; i < view.rows.size(); ++i) {
    const ForestRow& row = view.rows[i];
    if (row.parent) text += fmt::format("  d{} -> d{}\n", *row.parent, i);
    for (const std::size_t read : row.reads)
      text += fmt::format("  d{} -> d{} [style=dotted, label=\"reads\"]\n", read, i);
    if (row.bus) text += fmt::format("  d{} -> b{} [style=dashed, arrowhead=none]\n", i, *row.bus);
  }
  return text + "}\n";
}

std::string forest_mermaid(const ForestView& view) {
  std::string text = "flowchart LR\n";
  for (std::size_t i = 0; i < view.rows.size(); ++i)
    text += fmt::format("  d{}[{}]\n", i, joined(lines_of(view.rows[i]), "<br/>", mermaid_quoted));
  for (std::size_t i = 0; i < view.buses.size(); ++i)
    text += fmt::format("  b{}([{}])\n", i, joined(lines_of(view.buses[i]), "<br/>", mermaid_quoted));
  for (std::size_t i = 0; i < view.rows.size(); ++i) {
    const ForestRow& row = view.rows[i];
    if (row.parent) text += fmt::format("  d{} --> d{}\n", *row.parent, i);
    for (const std::size_t read : row.reads) text += fmt::format("  d{} -. reads .-> d{}\n", read, i);
    if (row.bus) text += fmt::format("  d{} -.- b{}\n", i, *row.bus);
  }
  return text;
}

}  // namespace finemote::gen
