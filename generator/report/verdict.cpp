#include "generator/report/verdict.hpp"

#include <fmt/format.h>

#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

std::string late_buckets(const Place& verdict) {
  std::string text;
  const Place buckets = verdict["buckets"];
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    if (buckets[i]["ok"].is_true()) continue;
    text += (text.empty() ? "" : ", ") + shown(buckets[i]["period_ns"].value(), Unit::time);
  }
  return text;
}

/// How many of a list are not `ok`.
std::size_t failed(const Place& list) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < list.size(); ++i) count += list[i]["ok"].is_true() ? 0 : 1;
  return count;
}

bool is_broken(const Place& figure) { return figure["judged"].text() == "broken"; }

/// Measured above the bound, anywhere in a run.
bool has_broken(const Documents& documents) {
  const Place run = documents.of_run();
  for (const char* list : {"responses", "jitter", "claims"}) {
    for (std::size_t i = 0; i < run[list].size(); ++i) {
      if (is_broken(run[list][i])) return true;
    }
  }
  for (std::size_t i = 0; i < run["chains"].size(); ++i) {
    for (const char* part : {"acquire", "decide", "wire", "end_to_end"}) {
      if (is_broken(run["chains"][i][part])) return true;
    }
  }
  return false;
}

/// The chain with the largest value of a member, where some has one.
Place worst_chain(const Documents& documents, const char* member) {
  const Place chains = documents.of_timing()["chains"];
  Place worst = chains[chains.size()];
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Place chain = chains[i];
    if (chain[member].is_number() && (!worst.exists() || chain[member].number() > worst[member].number()))
      worst = chain;
  }
  return worst;
}

std::string card(const std::string& title, const std::string& value, const std::string& below) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd><dd class=\"below\">{}</dd></div>\n", title, value, below);
}

std::string age_card(const Documents& documents) {
  const bool has_wire = worst_chain(documents, "end_to_end_ns").exists();
  const char* member = has_wire ? "end_to_end_ns" : "decide_ns";
  const Place worst = worst_chain(documents, member);
  if (!worst.exists()) return card("Worst age of a command", "no bound", "of no chain");
  const std::string from = worst["from"].text(), to = worst["to"].text();
  std::string value = "<span class=\"whole\">" + worst[member].figure(Unit::time) + " bound</span>";
  const Place measured = Measurements(documents).chain(from, to)[has_wire ? "end_to_end" : "decide"]["max_ns"];
  if (measured.is_number()) value += ", <span class=\"whole\">" + measured.figure(Unit::time) + " measured</span>";
  return card(has_wire ? "Worst age of a command" : "Longest decision", value,
              svg::escaped(from + " → " + to) + (worst["assumed"].is_true() ? ", on assumed times" : ""));
}

std::string bus_card(const Documents& documents) {
  const Place loads = documents.of_timing()["bus_load"];
  Place busiest = loads[loads.size()];
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (!busiest.exists() || loads[i]["utilization"].number() > busiest["utilization"].number()) busiest = loads[i];
  }
  if (!busiest.exists()) return {};
  return card("Busiest bus", busiest["utilization"].figure(Unit::share), svg::escaped(busiest["name"].text()));
}

std::string run_cards(const Documents& documents) {
  const Place run = documents.of_run();
  const Place image = run["image"];
  std::string text;
  if (image["flash"].is_number()) {
    text += card("Flash", image["flash"].figure(Unit::bytes), "of the image");
    text += card("RAM", image["ram"].figure(Unit::bytes),
                 image["stack"].is_number() ? "and " + image["stack"].figure(Unit::bytes) + " of stack, proven" : "");
  }
  text += card("Measured for", run["duration_ns"].figure(Unit::time),
               "overruns: " + run["overruns"].figure(Unit::count) + ", order " +
                   (run["order"]["mistake"].text().empty() ? run["order"]["judged"].is_true() ? "kept" : "not judged"
                                                           : "broken"));
  return text;
}

}  // namespace

Verdict verdict_of(const Documents& documents, const std::string& robot) {
  const Place timing = documents.of_timing();
  if (!timing["schedulable"].is_true())
    return {false, robot + " can miss a deadline: devices every " + late_buckets(documents.of_verdict())};
  if (has_broken(documents)) return {false, robot + " was measured above a bound"};
  if (documents.of_run()["overruns"].number() > 0) return {false, robot + " overran its period in the run"};
  if (documents.of_run()["resets"].number() > 0) return {false, robot + " was reset in the run"};
  const std::size_t all = timing["requirements"].size();
  if (const std::size_t count = failed(timing["requirements"]); count > 0)
    return {false, fmt::format("{} keeps every deadline, but fails {} of {} requirements", robot, count, all)};
  const Place wanted = documents.of_run()["expectations"];
  if (const std::size_t count = failed(wanted); count > 0)
    return {false, fmt::format("{} keeps every deadline, but fails {} of {} expectations of the scenario", robot, count,
                               wanted.size())};
  return {true, robot + (all > 0 ? " keeps every deadline and every requirement" : " keeps every deadline")};
}

std::string headline_figures(const Documents& documents) {
  const Place timing = documents.of_timing();
  return "<dl class=\"figures\">\n" + age_card(documents) +
         card("Processor", timing["processor_load"].figure(Unit::share), "busy in the worst case") +
         bus_card(documents) + (documents.has_run() ? run_cards(documents) : "") + "</dl>\n";
}

}  // namespace finemote::gen::report
