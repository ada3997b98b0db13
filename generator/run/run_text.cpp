#include "generator/run/run_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/run/run_summary.hpp"
#include "generator/run/violation.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

double microseconds_of(Duration time) { return static_cast<double>(time.ns()) / 1e3; }
double milliseconds_of(Duration time) { return static_cast<double>(time.ns()) / 1e6; }

std::string name_of(const RunResult& result, const MeasuredChain& chain) {
  return name_of(result, chain.from) + " -> " + name_of(result, chain.to);
}

/// The column of the chains, as wide as the longest of them.
std::size_t chain_width(const RunResult& result) {
  std::size_t width = 28;
  for (const MeasuredChain& chain : result.figures.chains) width = std::max(width, name_of(result, chain).size());
  return width;
}

std::string seen_text(const ExpectationRecord& e) {
  if (!e.lowest) return e.finite ? "nothing: the run ended before" : "values that are not finite";
  return fmt::format("{:.6g} to {:.6g}{}", *e.lowest, *e.highest, e.finite ? "" : " and values that are not finite");
}

void print_expectations(const RunResult& result, std::ostream& out) {
  if (result.record.expectations.empty()) return;
  out << "\nexpected by the scenario\n";
  for (const ExpectationRecord& e : result.record.expectations) {
    out << fmt::format("  {:>9.3f} to {:>9.3f} ms  {:<24} {:.6g} to {:.6g}, seen {}{}\n", milliseconds_of(e.from),
                       milliseconds_of(e.to), e.part + "." + e.value, e.min, e.max, seen_text(e),
                       e.ok ? "" : "  NOT AS EXPECTED");
  }
}

/// The stages in the order they began, one line per release of the fastest bucket.
void print_order(const RunResult& result, std::ostream& out) {
  out << "\nobserved order (+ update, - handle)\n";
  const Duration step = result.schedule.buckets.front().period;
  std::string line;
  std::optional<Duration> shown;
  for (const Event& event : result.record.events) {
    if (event.at >= result.shown) break;
    if (event.is_end) continue;
    const Duration release = round_down(event.at, step);
    if (release != shown) {
      if (!line.empty()) out << line << "\n";
      line = fmt::format("  {:>8.3f} ms ", milliseconds_of(release));
      shown = release;
    }
    line += fmt::format(" {}{}", event.is_handle ? '-' : '+', name_of(result, event.device));
  }
  out << line << "\n";
}

void print_figure(const std::string& name, std::size_t width, const char* part, const Measured& figure,
                  std::ostream& out) {
  const Statistics& s = figure.observed;
  if (s.count == 0) return;
  out << fmt::format("  {:<{}} {:<10} {:>7} {:>11.3f} {:>11.3f} {:>11.3f} {:>9.3f} {:>11}{}\n", name, width, part,
                     s.count, microseconds_of(s.min), s.mean_ns / 1e3, microseconds_of(s.max), s.sd_ns / 1e3,
                     figure.bound ? fmt::format("{:.3f}", microseconds_of(*figure.bound)) : "-",
                     figure.judged() == Judgement::broken ? "  ABOVE ITS BOUND" : "");
}

/// In QEMU every instruction takes 8 ns, so times of a busy processor are counts.
void print_instructions(const RunResult& result, std::ostream& out) {
  if (!result.record.instruction_time) return;
  const Duration each = *result.record.instruction_time;
  const std::size_t width = chain_width(result);
  out << "\nthe same in instructions: update to handle\n";
  for (const MeasuredChain& chain : result.figures.chains) {
    const Statistics& s = chain.decide.observed;
    if (s.count == 0) continue;
    out << fmt::format("  {:<{}} {} to {}, jitter {}\n", name_of(result, chain), width, floor_div(s.min, each),
                       floor_div(s.max, each), floor_div(s.max - s.min, each));
  }
}

/// The chains with the least room to their bounds first; those without bound last.
std::vector<const MeasuredChain*> by_room(const RunResult& result) {
  std::vector<const MeasuredChain*> chains;
  for (const MeasuredChain& chain : result.figures.chains) chains.push_back(&chain);
  const auto use = [](const MeasuredChain* chain) {
    const Measured& whole = whole_of(*chain);
    return whole.observed.count > 0 && whole.bound ? timing::ratio(whole.observed.max, *whole.bound) : -1;
  };
  std::stable_sort(chains.begin(), chains.end(),
                   [&](const MeasuredChain* a, const MeasuredChain* b) { return use(a) > use(b); });
  return chains;
}

/// Of the chains with the least room the whole, and every part that is above its bound.
void print_tightest(const RunResult& result, std::size_t width, std::ostream& out) {
  constexpr std::size_t kFew = 5;
  const auto chains = by_room(result);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (const auto& figure : kChainFigures) {
      const Measured& measured = chains[i]->*figure.measured;
      const bool is_whole = i < kFew && &measured == &whole_of(*chains[i]);
      if (is_whole || measured.judged() == Judgement::broken)
        print_figure(name_of(result, *chains[i]), width, figure.name, measured, out);
    }
  }
  if (chains.size() > 1) out << "  -v shows all chains with all their parts, responses and the observed order\n";
}

void print_chains(const RunResult& result, bool is_verbose, std::ostream& out) {
  if (result.figures.chains.empty()) return;
  out << "\nage of the data behind a command, us: sample (acquire) update (decide) handle (wire) output\n";
  const std::size_t width = chain_width(result);
  out << fmt::format("  {:<{}} {:<10} {:>7} {:>11} {:>11} {:>11} {:>9} {:>11}\n", "chain", width, "part", "samples",
                     "min", "mean", "max", "sd", "bound");
  if (!is_verbose) return print_tightest(result, width, out);
  for (const MeasuredChain& chain : result.figures.chains) {
    for (const auto& figure : kChainFigures)
      print_figure(name_of(result, chain), width, figure.name, chain.*figure.measured, out);
  }
}

std::string beside(const Measured& figure) {
  const std::string seen =
      figure.observed.count > 0 ? fmt::format("{:.3f}", microseconds_of(figure.observed.max)) : "-";
  return fmt::format("{:>11} {:>11}", seen, figure.bound ? fmt::format("{:.3f}", microseconds_of(*figure.bound)) : "-");
}

bool is_broken(const MeasuredResponse& response) {
  return std::any_of(kResponseFigures.begin(), kResponseFigures.end(),
                     [&](const auto& figure) { return (response.*figure.measured).judged() == Judgement::broken; });
}

/// All of them, or those that are above a bound.
void print_responses(const RunResult& result, bool is_verbose, std::ostream& out) {
  const std::vector<MeasuredResponse>& all = result.figures.responses;
  if (is_verbose ? all.empty() : std::none_of(all.begin(), all.end(), is_broken)) return;
  out << "\nrelease to end of a stage, and jitter of handle(), us: longest seen and bound\n";
  out << fmt::format("  {:<28} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "device", "update", "bound", "handle",
                     "bound", "jitter", "bound");
  for (const MeasuredResponse& response : result.figures.responses) {
    if (!is_verbose && !is_broken(response)) continue;
    out << fmt::format("  {:<28} {} {} {}{}\n", name_of(result, response.device), beside(response.update),
                       beside(response.handle), beside(response.jitter),
                       is_broken(response) ? "  ABOVE ITS BOUND" : "");
  }
}

/// Time stamps that cannot be true, and data that are too old by them.
void print_claims(const RunResult& result, std::ostream& out) {
  for (const MeasuredClaim& claim : result.figures.claims) {
    const std::string& name = name_of(result, claim.device);
    if (claim.lead.judged() == Judgement::broken)
      out << fmt::format("\nFALSE TIME STAMP: '{}' claims data up to {:.3f} us fresher than they are\n", name,
                         microseconds_of(claim.lead.observed.max));
    if (claim.age.judged() == Judgement::broken)
      out << fmt::format(
          "\nOLD DATA: '{}' has data that it says are valid and up to {:.3f} us old: acquire has a bound of {:.3f} "
          "us\n",
          name, microseconds_of(claim.age.observed.max), microseconds_of(*claim.age.bound));
  }
}

void print_monitor(const RunResult& result, std::ostream& out) {
  if (result.record.monitor.empty()) return;
  const auto time = [](std::optional<Duration> value) {
    return value ? fmt::format("{:.3f}", microseconds_of(*value)) : "-";
  };
  out << "\nmonitored in the firmware, us: release to end of handle, and age of the data behind the command\n";
  out << fmt::format("  {:<28} {:>11} {:>11} {:>7} {:>11} {:>11} {:>7}\n", "device", "response", "bound", "above",
                     "age", "bound", "above");
  for (const MonitorEntry& entry : result.record.monitor) {
    const timing::DeviceBounds& of = result.bounds.devices[entry.device];
    const auto age = entry.age_max > Duration::zero() ? std::optional(entry.age_max) : std::nullopt;
    out << fmt::format("  {:<28} {:>11} {:>11} {:>7} {:>11} {:>11} {:>7}\n", name_of(result, entry.device),
                       time(entry.response_max), time(of.response), entry.response_violations, time(age), time(of.age),
                       entry.age_violations);
  }
}

/// Measured execution times, ready to paste.
void print_wcets(const RunResult& result, std::ostream& out) {
  if (result.wcets.empty()) return;
  out << "\nmeasured here, of devices whose execution times are assumed: the longest run seen plus 25 %\n";
  for (const MeasuredWcet& wcet : result.wcets)
    out << fmt::format("  {:<28} {}\n", name_of(result, wcet.device), wcet_element(wcet));
}

bool is_without(const MeasuredChain& chain, const Figure<MeasuredChain>& figure) {
  return figure.measured == &MeasuredChain::wire && !chain.has_wire;
}
bool is_without(const MeasuredResponse&, const Figure<MeasuredResponse>&) { return false; }

/// What has no sample or no bound, a line each.
void print_unjudged(const RunResult& result, std::ostream& out) {
  if (!result.must_judge || result.is_all_judged()) return;
  const auto reason = [](const Measured& figure) -> const char* {
    return figure.judged() == Judgement::no_bound    ? "no bound"
           : figure.judged() == Judgement::no_sample ? "no sample"
                                                     : nullptr;
  };
  std::string lines;
  const std::size_t width = chain_width(result);
  const auto add = [&](const std::string& name, const auto& of, const auto& figures) {
    std::string list;
    for (const auto& figure : figures) {
      const char* why = is_without(of, figure) ? nullptr : reason(of.*figure.measured);
      if (why != nullptr) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", figure.name, why);
    }
    if (!list.empty()) lines += fmt::format("  {:<{}} {}\n", name, width, list);
  };
  for (const MeasuredChain& chain : result.figures.chains) add(name_of(result, chain), chain, kChainFigures);
  for (const MeasuredResponse& r : result.figures.responses) add(name_of(result, r.device), r, kResponseFigures);
  for (const MeasuredClaim& claim : result.figures.claims) {
    if (claim.age.judged() == Judgement::no_sample)
      lines += fmt::format("  {:<{}} its data ({})\n", name_of(result, claim.device), width,
                           result.record.scripted_resets > 0 && result.record.violated_from < result.record.ready
                               ? "not judged after a reset"
                               : "never seen to be valid");
  }
  if (!lines.empty()) out << "\nnot judged\n" << lines;
}

std::string verdict_text(const std::vector<std::string>& failures) {
  return failures.empty() ? "passed" : fmt::format("FAILED: {}", fmt::join(failures, "; "));
}

/// What the bring-up ended with, and the parts that were waited for in vain or that nobody plays.
std::string seen_parts_text(const RunResult& result) {
  std::vector<std::string> missing = result.record.absent;
  for (const std::string& device : result.record.silent) missing.push_back(device + " (no model)");
  return missing.empty() ? ", when every part had been seen"
                         : fmt::format("; never seen: {}", fmt::join(missing, ", "));
}

/// `, declared 12.3 % at most`: how much of a time as long as the run the busier line of a bus can be in use.
std::string declared_text(const std::vector<MeasuredTraffic>& all, BusId bus) {
  const MeasuredTraffic* found = find_traffic(all, bus);
  if (found == nullptr || !found->sent.most || found->window < milliseconds(1)) return "";
  Duration most = *found->sent.most;
  if (found->received && !found->received->most) return "";
  if (found->received) most = std::max(most, *found->received->most);
  const double share = static_cast<double>(most.ns()) / static_cast<double>(found->window.ns());
  return fmt::format(", declared {:.1f} % at most", 100 * share);
}

}  // namespace

void print_image(const ImageFacts& image, std::ostream& out) {
  if (image.flash == 0) return;
  out << fmt::format("flash {} B, RAM {} B{}, stack {}\n", image.flash, image.ram,
                     image.code_ram > 0 ? fmt::format(" and {} B of code", image.code_ram) : "",
                     image.stack ? fmt::format("{} B (proven worst case)", *image.stack) : "without bound");
}

void print_run(const RunResult& result, const std::vector<std::string>& failures, bool is_verbose, std::ostream& out) {
  const Duration lasted = std::max(result.duration, round_up(result.record.judged_for, microseconds(1)));
  out << fmt::format("{} on {}, {}{}: {}\n", result.robot.name.text, result.board, units::spaced_duration(lasted),
                     lasted > round_up(result.duration, microseconds(1)) ? ", as long as the scenario lasts" : "",
                     verdict_text(failures));
  if (result.must_judge)
    out << fmt::format("judged from {:.3f} ms on{}\n", milliseconds_of(result.record.ready), seen_parts_text(result));
  if (result.phases > 1)
    out << fmt::format("{} runs with random phases and clock errors of seed {}\n", result.phases, result.seed);
  print_image(result.image, out);
  if (!result.record.flash.empty())
    out << fmt::format("times are derived from instructions; fetches from flash {}\n",
                       result.record.flash == "hit" ? "hit its accelerator" : "always miss its accelerator");
  if (const SiliconChoice& silicon = result.record.silicon; !silicon.names.empty())
    out << fmt::format("the chip uses the freedom its manual leaves in {}, as seed {} draws it\n",
                       fmt::join(silicon.names, ", "), silicon.seed);
  if (result.record.flash == "miss")
    out << "bounds are those of the execution times that the robot has, whatever the fetches cost\n";
  print_summary(result, out);
  if (is_verbose) print_order(result, out);
  print_chains(result, is_verbose, out);
  print_responses(result, is_verbose, out);
  print_claims(result, out);
  print_monitor(result, out);
  print_instructions(result, out);
  if (!result.record.buses.empty()) out << "\nbuses\n";
  for (const BusRecord& bus : result.record.buses) {
    out << fmt::format("  {:<12} {:>7} transfers {:>4} errors  busy {:.1f} %{}\n",
                       result.robot.buses[bus.bus].name.text, bus.transfers, bus.errors, 100 * bus.busy,
                       declared_text(result.figures.traffic, bus.bus));
  }
  if (!result.record.violated.empty())
    out << fmt::format("\nthe scenario violates assumptions of the bounds ({}): those that rest on them do not count\n",
                       fmt::join(assumptions_of(result.record.violated), ", "));
  print_expectations(result, out);
  print_wcets(result, out);
  if (!result.record.silent.empty())
    out << fmt::format(
        "\nnote: parts without a model on the emulated board never answer: {} ('emulation' in a descriptor names "
        "one)\n",
        fmt::join(result.record.silent, ", "));
  print_unjudged(result, out);
}

}  // namespace finemote::gen
