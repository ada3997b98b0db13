#include "generator/report/verdict.hpp"

#include <fmt/format.h>

#include <map>

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

std::string devices_text(std::size_t count, bool is_first) {
  return std::to_string(count) + (is_first ? count == 1 ? " device" : " devices" : "");
}

/// How many of a list are not `ok`.
std::size_t failed(const Place& list) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < list.size(); ++i) count += list[i]["ok"].is_true() ? 0 : 1;
  return count;
}

/// How the parts of a run that have a bound were judged.
struct Judged {
  std::size_t measured = 0;  ///< held or broken
  std::size_t broken = 0;
  std::size_t unmeasured = 0;  ///< there is a bound, and nothing to hold against it

  void add(const Place& figure) {
    const std::string word = figure["judged"].text();
    measured += word == "held" || word == "broken" ? 1 : 0;
    broken += word == "broken" ? 1 : 0;
    unmeasured += word == "no-sample" ? 1 : 0;
  }
};

Judged judged_of(const Place& run) {
  Judged judged;
  for (const char* list : {"responses", "jitter", "claims"}) {
    for (std::size_t i = 0; i < run[list].size(); ++i) judged.add(run[list][i]);
  }
  for (std::size_t i = 0; i < run["chains"].size(); ++i) {
    for (const char* part : {"acquire", "decide", "wire", "end_to_end"}) judged.add(run["chains"][i][part]);
  }
  return judged;
}

/// The first stage that took longer by itself than the analysis was told; empty where there is none.
std::string too_long(const Place& run) {
  const Place stages = run["stages"];
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const Place own = stages[i]["own_max_ns"], given = stages[i]["wcet_ns"];
    if (own.is_number() && given.is_number() && own.number() > given.number())
      return stages[i]["device"].text() + "'s " + stages[i]["stage"].text() + "()";
  }
  return {};
}

bool has_violations(const Place& run) {
  const Place list = run["monitor"];
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i]["response_violations"].number() > 0 || list[i]["age_violations"].number() > 0) return true;
  }
  return false;
}

/// Why a run is not as it should be; empty where it is.
std::string trouble_of(const Place& run) {
  const Judged judged = judged_of(run);
  const bool is_excused = run["faults"].is_true();  // the scenario violates an assumption
  if (!is_excused && judged.broken > 0) return "was measured above a bound";
  if (!is_excused && has_violations(run)) return "counted a time above its bound in the run";
  if (run["overruns"].number() > 0) return "overran its period in the run";
  if (run["resets"].number() > 0) return "was reset in the run";
  if (!run["order"]["mistake"].text().empty()) return "ran a stage out of order";
  if (const std::string stage = too_long(run); !stage.empty())
    return "took longer in the run than its analysis was told: " + stage;
  if (run["unexplained_faults"].size() > 0)
    return "counted a fault in the run that nothing explains: " + run["unexplained_faults"][0]["module"].text();
  if (judged.measured == 0 && judged.unmeasured > 0) return "was run, but nothing was measured that has a bound";
  return {};
}

/// How many chains have a part that nothing bounds.
std::size_t unbounded(const Place& chains) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) count += chains[i]["unbounded"].size() > 0 ? 1 : 0;
  return count;
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
  const Place chains = documents.of_timing()["chains"];
  if (!worst.exists()) {
    const char* why = chains.size() > 0 ? "where a deadline can be missed" : "no device takes a command";
    return card("Worst age of a command", "no bound", why);
  }
  const std::string from = worst["from"].text(), to = worst["to"].text();
  std::string value = "<span class=\"whole\">" + worst[member].figure(Unit::time) + " bound</span>";
  const Place measured = Measurements(documents).chain(from, to)[has_wire ? "end_to_end" : "decide"]["max_ns"];
  if (measured.is_number()) value += ", <span class=\"whole\">" + measured.figure(Unit::time) + " measured</span>";
  std::string below = svg::escaped(from + " → " + to);
  if (worst["assumed"].is_true()) below += ", rests on assumed times";
  if (const std::size_t count = unbounded(chains); count > 0)
    below += fmt::format("; {} of {} chains have no bound", count, chains.size());
  return card(has_wire ? "Worst age of a command" : "Longest decision", value, below);
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
  const char* order = !run["order"]["mistake"].text().empty() ? "broken"
                      : run["order"]["judged"].is_true()      ? "kept"
                                                              : "not judged";
  text += card("Measured for", run["duration_ns"].figure(Unit::time),
               fmt::format("overruns: {}, order of stages {}", run["overruns"].figure(Unit::count), order));
  const Place wanted = run["expectations"];
  if (wanted.size() > 0)
    text +=
        card("Scenario", fmt::format("{} of {}", wanted.size() - failed(wanted), wanted.size()), "expectations met");
  return text;
}

}  // namespace

Verdict verdict_of(const Documents& documents, const std::string& robot) {
  using Look = Verdict::Look;
  const Place timing = documents.of_timing();
  if (!timing["schedulable"].is_true())
    return {Look::bad, robot + " can miss a deadline: devices every " + late_buckets(documents.of_verdict())};
  if (const std::string trouble = trouble_of(documents.of_run()); !trouble.empty())
    return {Look::bad, robot + " " + trouble};
  const std::string so_far = robot + " meets every deadline";
  const std::size_t all = timing["requirements"].size();
  if (const std::size_t count = failed(timing["requirements"]); count > 0)
    return {Look::bad, fmt::format("{}, but fails {} of {} requirements", so_far, count, all)};
  const Place wanted = documents.of_run()["expectations"];
  if (const std::size_t count = failed(wanted); count > 0)
    return {Look::bad,
            fmt::format("{}, but fails {} of {} expectations of the scenario", so_far, count, wanted.size())};
  if (const std::size_t count = unbounded(timing["chains"]); count > 0)
    return {Look::open, fmt::format("{}, but nothing bounds the age of commands in {} of {} chains", so_far, count,
                                    timing["chains"].size())};
  return {Look::good, so_far + (all > 0 ? " and every requirement" : "")};
}

std::string rests_on(const Documents& documents) {
  const Place labels = documents.of_timing()["wcet_labels"];
  std::map<std::string, std::size_t> counts;
  for (std::size_t i = 0; i < labels.size(); ++i) ++counts[labels[i]["label"].text()];
  std::string text;
  for (const char* label : {"static", "measured", "declared", "assumed"}) {
    if (counts[label] > 0)
      text += fmt::format("{}{} for {}", text.empty() ? "" : ", ", label, devices_text(counts[label], text.empty()));
  }
  return text.empty() ? text : "Execution times: " + text + ".";
}

std::string headline_figures(const Documents& documents) {
  const Place timing = documents.of_timing();
  return "<dl class=\"figures\">\n" + age_card(documents) +
         card("Processor", timing["processor_load"].figure(Unit::share), "busy at most, in the long run") +
         bus_card(documents) + (documents.has_run() ? run_cards(documents) : "") + "</dl>\n";
}

}  // namespace finemote::gen::report
