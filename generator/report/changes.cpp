#include "generator/report/changes.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

#include "generator/report/table.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

/// What is compared of two things of one name.
struct Property {
  const char* member;
  const char* title;
  Unit unit;
  bool less_is_better = true;
};

/// Rows of the table, and how many of them say what.
struct Changes {
  std::map<std::string, std::string> rows = {};    ///< by word of it, as are the counts
  std::map<std::string, std::size_t> counts = {};  ///< by word: `better`, `worse`, `added`, `removed`, `changed`

  void add(const std::string& subject, const char* title, const Place& before, const Place& after, Unit unit,
           const std::string& word_of_it) {
    rows[word_of_it] += fmt::format("<tr class=\"{}\">", word_of_it) + row_title(subject) + word(title) +
                        before.cell(unit) + after.cell(unit) +
                        fmt::format("<td class=\"state\">{}</td></tr>\n", word_of_it);
    ++counts[word_of_it];
  }

  void add(const std::string& subject, const std::string& word_of_it) {
    rows[word_of_it] += fmt::format("<tr class=\"{}\">", word_of_it) + row_title(subject) + word("") +
                        "<td>–</td><td>–</td>" + fmt::format("<td class=\"state\">{}</td></tr>\n", word_of_it);
    ++counts[word_of_it];
  }
};

/// A bound that is gone is worse than any, and one that is new better.
const char* word_for(const Property& property, const Place& before, const Place& after) {
  if (!property.less_is_better) return "changed";
  if (!after.is_number()) return "worse";
  if (!before.is_number()) return "better";
  return after.number() < before.number() ? "better" : "worse";
}

void compare(const std::string& subject, const std::vector<Property>& properties, const Place& before,
             const Place& after, Changes& changes) {
  for (const Property& property : properties) {
    const Place old = before[property.member], now = after[property.member];
    const bool is_same = old.exists() == now.exists() && (!old.exists() || old.value() == now.value());
    if (!is_same) changes.add(subject, property.title, old, now, property.unit, word_for(property, old, now));
  }
}

/// The elements of a list by what `name` makes of each.
template <class Name>
std::map<std::string, Place> by_name(const Place& list, Name name) {
  std::map<std::string, Place> found;
  for (std::size_t i = 0; i < list.size(); ++i) found.emplace(name(list[i]), list[i]);
  return found;
}

/// Compares what has one name in both lists; with `says_missing` also tells what is in one alone.
template <class Name>
void compare_lists(const Place& before, const Place& after, Name name, const std::vector<Property>& properties,
                   bool says_missing, Changes& changes) {
  const auto old = by_name(before, name), now = by_name(after, name);
  for (const auto& [subject, place] : now) {
    const auto was = old.find(subject);
    if (was != old.end()) compare(subject, properties, was->second, place, changes);
    if (was == old.end() && says_missing) changes.add(subject, "added");
  }
  for (const auto& [subject, place] : old) {
    if (says_missing && now.count(subject) == 0) changes.add(subject, "removed");
  }
}

std::string chain_name(const Place& chain) { return chain["from"].text() + " → " + chain["to"].text(); }

/// By the device that is commanded: the chain of the oldest command among those that the other document lacks.
std::map<std::string, Place> oldest_alone(const Place& chains, const std::map<std::string, Place>& others) {
  const auto is_older = [](const Place& one, const Place& than) {
    const Place age = one["end_to_end_ns"], other = than["end_to_end_ns"];
    return other.is_number() && (!age.is_number() || age.number() > other.number());
  };
  std::map<std::string, Place> oldest;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (others.count(chain_name(chains[i])) != 0) continue;
    const auto [place, is_new] = oldest.emplace(chains[i]["to"].text(), chains[i]);
    if (!is_new && is_older(chains[i], place->second)) place->second = chains[i];
  }
  return oldest;
}

/// A document has the chains of the oldest commands. Where those of a device come from elsewhere now, both are
/// compared.
void compare_chains(const Place& before, const Place& after, Changes& changes) {
  const Property age{"end_to_end_ns", "age, end to end", Unit::time};
  compare_lists(before, after, chain_name, {age, {"decide_ns", "decide", Unit::time}}, false, changes);
  const auto old = oldest_alone(before, by_name(after, chain_name));
  for (const auto& [device, now] : oldest_alone(after, by_name(before, chain_name))) {
    const auto was = old.find(device);
    if (was == old.end()) continue;
    compare(chain_name(now) + ", before " + was->second["from"].text(), {age}, was->second, now, changes);
  }
}

void compare_requirements(const Place& before, const Place& after, Changes& changes) {
  const auto name = [](const Place& r) { return "requirement " + r["text"].text() + " (" + r["kind"].text() + ")"; };
  const auto old = by_name(before, name);
  for (const auto& [subject, place] : by_name(after, name)) {
    const auto was = old.find(subject);
    if (was == old.end()) continue;
    const Unit unit = place["kind"].text() == "utilization" ? Unit::share : Unit::time;
    compare(subject, {{"max", "limit", unit, false}}, was->second, place, changes);
    const bool ok = place["ok"].is_true();
    if (was->second["ok"].is_true() != ok)
      changes.add(subject, ok ? "met now" : "not met any more", was->second["value"], place["value"], unit,
                  ok ? "better" : "worse");
  }
  compare_lists(before, after, name, {}, true, changes);
}

Changes all_changes(const Documents& documents) {
  Changes changes;
  const Place before = documents.of_against(), after = documents.of_timing();
  const auto device = [](const Place& one) { return "device " + one["name"].text(); };
  const auto response = [](const Place& one) { return "response of " + one["name"].text(); };
  const auto bus = [](const Place& one) { return "bus " + one["name"].text(); };
  compare_requirements(before["requirements"], after["requirements"], changes);
  compare_chains(before["chains"], after["chains"], changes);
  compare("processor", {{"processor_load", "load", Unit::share}}, before, after, changes);
  compare_lists(before["bus_load"], after["bus_load"], bus, {{"utilization", "load", Unit::share}}, true, changes);
  compare_lists(before["model"]["devices"], after["model"]["devices"], device,
                {{"period_ns", "period", Unit::time, false},
                 {"update_wcet_ns", "own time of update()", Unit::time},
                 {"handle_wcet_ns", "own time of handle()", Unit::time}},
                true, changes);
  compare_lists(before[before["profile"].text()]["devices"], documents.of_verdict()["devices"], response,
                {{"r_minus_ns", "bound", Unit::time}}, false, changes);
  return changes;
}

}  // namespace

std::string changes_of(const Documents& documents) {
  if (!documents.of_against().exists()) return {};
  const Changes changes = all_changes(documents);
  const bool was_good = documents.of_against()["schedulable"].is_true();
  const bool is_good = documents.of_timing()["schedulable"].is_true();
  std::string text;
  if (was_good != is_good)
    text = fmt::format("<p class=\"{}\">{}</p>\n", is_good ? "better" : "worse",
                       is_good ? "Every deadline is met now; before, some could be missed."
                               : "Some deadline can be missed now; before, all were met.");
  if (changes.counts.empty()) return text + "<p>Nothing: every bound, load and requirement is what it was.</p>\n";
  std::string sentence, rows;
  for (const char* name : {"worse", "removed", "added", "changed", "better"}) {
    const auto count = changes.counts.find(name);
    if (count == changes.counts.end()) continue;
    sentence += fmt::format("{}{} {}", sentence.empty() ? "" : ", ", count->second, name);
    rows += changes.rows.at(name);
  }
  return text + fmt::format("<p>{}.</p>\n", sentence) + "<div class=\"changes\">" +
         table_of("changes-table", "What is different now",
                  {{"What"}, {"Property"}, {"Before", true}, {"Now", true}, {"Which is"}}, rows) +
         "</div>\n";
}

std::string earlier_bounds(const Documents& documents) {
  const Place chains = documents.of_against()["chains"];
  std::string rows;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    rows += "<tr>" + row_title(chain_name(chains[i]));
    for (const char* part : {"acquire_ns", "decide_ns", "wire_ns", "end_to_end_ns"})
      rows += chains[i][part].cell(Unit::time);
    rows += "</tr>\n";
  }
  if (rows.empty()) return {};
  return "<details><summary>Bounds before, as a table</summary>\n" +
         table_of("earlier-table", "Age of every command before the change",
                  {{"Chain"}, {"Acquire", true}, {"Decide", true}, {"Wire", true}, {"End to end", true}}, rows) +
         "</details>\n";
}

}  // namespace finemote::gen::report
