#include "emulator/scenario/page.hpp"

#include <fmt/format.h>

#include <map>

#include "emulator/scenario/grammar.hpp"

namespace finemote::scenario {
namespace {

std::string shown_name(const std::string& name, int last) {
  return last < 0 ? fmt::format("`{}`", name) : fmt::format("`{0}0`..`{0}{1}`", name, last);
}

std::string shown_range(const Member& row) {
  if (row.kind == Member::Kind::choice) {
    std::string text;
    for (const std::string& word : row.choices) text += (text.empty() ? " " : " or ") + word;
    return text;
  }
  if (row.min == -kAny || row.max == kAny || row.max >= 1e7) return {};
  return row.min == row.max ? fmt::format(" {}", row.min) : fmt::format(" {}..{}", row.min, row.max);
}

/// `torque` [N m] on the output
std::string shown(const Member& row) {
  std::string text = shown_name(row.name, row.last) + shown_range(row);
  if (!row.unit.empty()) text += " [" + row.unit + "]";
  if (!row.summary.empty()) text += " " + row.summary;
  if (!row.usual.empty()) text += fmt::format(", {} if absent", row.usual);
  if (row.members.empty()) return text;
  text += " (";
  for (const Member& member : row.members) text += (&member == row.members.data() ? "`" : " `") + member.name + "`";
  return text + ")";
}

std::string list_of(const std::vector<Member>& rows) {
  std::string text;
  for (const Member& row : rows) text += (text.empty() ? "" : "; ") + shown(row);
  return text;
}

/// Rows that are the same for several models stand once.
using Rows = std::vector<std::pair<std::string, std::vector<std::string>>>;

void add_row(Rows& rows, const std::string& who, const std::string& row) {
  for (auto& [text, names] : rows) {
    if (text == row) return names.push_back(who);
  }
  rows.push_back({row, {who}});
}

std::string table(const std::string& head, const Rows& rows) {
  std::string text = head;
  for (const auto& [row, names] : rows) {
    std::string who;
    for (const std::string& name : names) who += (who.empty() ? "" : ", ") + name;
    text += fmt::format("| {} | {} |\n", who, row);
  }
  return text;
}

void add_verbs(Rows& rows, const std::string& who, const std::vector<Verb>& verbs) {
  for (const Verb& verb : verbs)
    add_row(
        rows, who,
        fmt::format("`{}` | {} | {} | {}", verb.name, verb.violates.empty() ? "" : fmt::format("`{}`", verb.violates),
                    verb.summary, list_of(verb.members)));
}

std::string shown(const Target& target) {
  if (target.key == "part") return fmt::format("`{}`", target.title);
  if (target.key == "pin") return "`\"pin\": \"PA0\"`";
  if (target.key.empty()) return "the board (no `part`, `port` or `pin`)";
  const auto& ports = target.port->ports;
  return ports.size() == 1 ? fmt::format("`\"port\": \"{}\"`", ports[0]) : target.title;
}

}  // namespace

std::string parts_table() {
  Rows rows;
  for (const Model& model : models())
    add_row(rows, fmt::format("`{}`", model.type), fmt::format("{} | {}", model.summary, list_of(model.figures)));
  return table("| type | behaviour | members of an entry |\n|---|---|---|\n", rows);
}

std::string actions_table() {
  Rows rows;
  for (const Target& target : targets()) add_verbs(rows, shown(target), *target.verbs);
  return table("| target | `do` | violates | effect | members |\n|---|---|---|---|---|\n", rows);
}

std::string values_table() {
  Rows rows;
  for (const Model& model : models()) {
    std::string values;
    for (const Quantity& row : model.values) {
      values += (values.empty() ? "" : "; ") + shown_name(row.name, row.last);
      if (!row.unit.empty()) values += " [" + row.unit + "]";
      if (!row.summary.empty()) values += " " + row.summary;
    }
    if (!values.empty()) add_row(rows, fmt::format("`{}`", model.type), values);
  }
  return table("| part | `value` |\n|---|---|\n", rows);
}

}  // namespace finemote::scenario
