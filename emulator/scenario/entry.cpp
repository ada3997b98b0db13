#include "emulator/scenario/entry.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::scenario {

namespace code = gen::code;

std::vector<std::string> names_of(const std::vector<Member>& rows) {
  std::vector<std::string> names;
  for (const Member& row : rows) {
    for (std::string& name : names_of(row.name, row.last)) names.push_back(std::move(name));
  }
  return names;
}

std::string item_name(const std::string& list, std::size_t number) { return fmt::format("{}[{}]", list, number); }

void EntryCheck::object(const Value& entry, const std::vector<Member>& rows, const std::string& whose) {
  for (const gen::json::Member& member : entry.members) {
    const Member* row = find_member(rows, member.key);
    if (row != nullptr) {
      value(*row, member.key, member.value);
    } else {
      diagnostics_.error(code::scenario_name, member.at, fmt::format("{} has no member '{}'", whose, member.key))
          .underline(member.key.size() + 2)
          .hint(gen::did_you_mean(member.key, names_of(rows)));
    }
  }
  complete(entry, rows, whose);
}

void EntryCheck::complete(const Value& entry, const std::vector<Member>& rows, const std::string& whose) {
  for (const Member& row : rows) {
    if (!row.required || entry.find(row.name) != nullptr) continue;
    auto& finding =
        diagnostics_.error(code::bad_scenario, entry.at, fmt::format("'{}' is missing in {}", row.name, whose))
            .underline(entry.length);
    if (!row.summary.empty()) finding.note(fmt::format("'{}': {}", row.name, row.summary));
  }
}

void EntryCheck::exactly_one(const Value& entry, const std::vector<std::string>& names, const std::string& whose) {
  std::vector<const gen::json::Member*> found;
  for (const gen::json::Member& member : entry.members) {
    if (std::find(names.begin(), names.end(), member.key) != names.end()) found.push_back(&member);
  }
  if (names.empty() || found.size() == 1) return;
  if (found.empty()) {
    diagnostics_.error(code::bad_scenario, entry.at, fmt::format("{} needs one of {}", whose, quoted(names, "and")))
        .underline(entry.length);
    return;
  }
  diagnostics_
      .error(code::bad_scenario, found[1]->at, fmt::format("{} has only one of {}", whose, quoted(names, "and")))
      .underline(found[1]->key.size() + 2);
}

bool EntryCheck::value(const Member& row, const std::string& name, const Value& value) {
  switch (row.kind) {
    case Member::Kind::part:
    case Member::Kind::reference:
      if (is_kind(name, value, Value::Kind::string)) names_.reference(row, value);
      return true;
    case Member::Kind::port:
      if (is_kind(name, value, Value::Kind::string)) names_.port(row, value);
      return true;
    case Member::Kind::object:
      if (!is_kind(name, value, Value::Kind::object)) return false;
      object(value, row.members, fmt::format("'{}'", name));
      exactly_one(value, row.one_of, fmt::format("'{}'", name));
      return true;
    case Member::Kind::list:
      if (!is_kind(name, value, Value::Kind::array)) return false;
      for (std::size_t i = 0; i < value.items.size(); ++i) {
        const std::string item = item_name(name, i);
        if (is_kind(item, value.items[i], Value::Kind::object))
          object(value.items[i], row.members, fmt::format("'{}'", item));
      }
      return true;
    default:
      return values_.simple(row, name, value);
  }
}

}  // namespace finemote::scenario
