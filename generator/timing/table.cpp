#include "generator/timing/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/timing/assumptions.hpp"
#include "generator/timing/cost_labels.hpp"
#include "generator/timing/shares.hpp"
#include "generator/timing/text_table.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

std::string verdict(const Timing& timing) {
  const auto failing = std::count_if(timing.requirements.begin(), timing.requirements.end(),
                                     [](const RequirementResult& r) { return !r.ok; });
  std::string requirements;
  if (failing > 0)
    requirements =
        fmt::format("; {} of {} requirements {}", failing, timing.requirements.size(), failing == 1 ? "fails" : "fail");
  if (failing == 0 && !timing.requirements.empty()) requirements = "; every requirement holds";
  return fmt::format("schedulable: {} (profile {}){}\n", timing.schedulable ? "yes" : "no", profile_name(timing.asked),
                     requirements);
}

/// What the times of the scheduler and of interrupts rest on; nothing where the model does not say.
std::string labels_of_costs(const Model& model) {
  const std::vector<CostLabel> costs = cost_labels(model);
  if (costs.front().source == WcetSource::unknown) return {};
  std::string text, separator = "  ";
  for (const WcetSource source :
       {WcetSource::computed, WcetSource::declared, WcetSource::measured, WcetSource::assumed}) {
    std::vector<std::string> names;
    for (const CostLabel& cost : costs) {
      if (cost.source == source) names.push_back(cost.what);
    }
    if (names.empty()) continue;
    const bool is_all = names.size() == costs.size();
    text += fmt::format("{}{}: {}", separator, label_of(source),
                        is_all ? "the release, jobs and all interrupts" : fmt::format("{}", fmt::join(names, ", ")));
    separator = "; ";
  }
  return text + "\n";
}

/// Who uses the processor, worst first.
std::string processor(const Timing& timing) {
  TextTable table({"used by", "", "every", "one", "load", "share"});
  for (const ProcessorUse& use : timing.processor) {
    std::string who(kind_name(use.kind));
    if (use.kind != ProcessorUse::Kind::release) who += " " + use.name;
    if (use.kind == ProcessorUse::Kind::flush) who += " every " + units::format_duration(use.every);
    if (!use.source.empty()) who += ", " + use.source;
    const bool is_least = use.kind == ProcessorUse::Kind::interrupt || use.kind == ProcessorUse::Kind::dma ||
                          use.kind == ProcessorUse::Kind::release;
    table.row({who, is_least ? "at least" : "", duration_text(use.every), duration_text(use.cost),
               percent(use.utilization), percent(use.utilization / timing.processor_load)});
  }
  return fmt::format("\nprocessor: {} of its time in the long run (profile {})\n", percent(timing.processor_load),
                     profile_name(timing.asked)) +
         table.text() + labels_of_costs(timing.model);
}

/// Figures of the classic tests, which decide nothing: the response times above do.
std::string informative(const Timing& timing) {
  const UtilizationTests& u = timing.utilization;
  return fmt::format(
      "\nfor comparison only, sufficient tests on the paper's model with every bus at tick rate: the response times "
      "above "
      "decide\n"
      "  utilisation {}, Liu-Layland {} at {}, hyperbolic {}\n",
      percent(u.utilization.value), u.liu_layland.ok ? "met" : "not met", percent(u.liu_layland.bound),
      u.hyperbolic_ok ? "met" : "not met");
}

std::string where_assumptions_are() {
  return fmt::format(
      "\nthe bounds rest on {} assumptions: --format json lists them, docs/timing.md#assumptions explains them\n",
      assumptions().size());
}

std::string buckets(const Timing& timing) {
  TextTable table({"period", "devices", "work", "response", "of period", ""});
  for (const BucketResult& b : timing.verdict().buckets) {
    table.row({duration_text(b.period), std::to_string(b.devices.size()), duration_text(b.wcet),
               duration_text(b.response), b.ok ? percent(ratio(b.response.value_or(Duration::zero()), b.period)) : "-",
               b.ok ? "ok" : "may miss its deadline"});
  }
  return "\nbuckets\n" + table.text();
}

std::string devices(const Timing& timing) {
  const bool windows = timing.asked != Profile::paper;
  std::vector<std::string> head{"device", "period", "update", "handle", "R+", "R-"};
  if (windows) head.emplace_back("window");
  head.emplace_back("wcet");
  TextTable table(head);
  for (const Rank d : timing.model.devices.ids()) {
    const Device& device = timing.model.devices[d];
    const DeviceResult& r = timing.verdict().devices[d];
    std::vector<std::string> cells{device.name,
                                   duration_text(device.period),
                                   duration_text(device.update_wcet),
                                   duration_text(device.handle_wcet),
                                   duration_text(r.r_plus),
                                   duration_text(r.r_minus)};
    if (windows) cells.push_back(duration_text(r.window));
    cells.emplace_back(label_of(device.source));
    table.row(cells);
  }
  return "\ndevices (R+, R-: release to end of update and handle; window: begin of update to end of handle)\n" +
         table.text();
}

std::string trees(const Timing& timing) {
  static constexpr std::string_view kClass[] = {"same period", "harmonic", "general"};
  TextTable table({"tree", "class", "latency", "worst leaf"});
  for (const TreeResult& t : timing.verdict().trees) {
    table.row({timing.model.devices[t.root].name, std::string(kClass[static_cast<int>(t.kind)]),
               duration_text(t.latency), t.worst_leaf ? timing.model.devices[*t.worst_leaf].name : "-"});
  }
  return "\ntrees (latency: begin of a leaf's update to the end of its handle that uses it)\n" + table.text();
}

std::string chains(const Timing& timing) {
  TextTable table({"chain", "acquire", "decide", "wire", "end to end", ""});
  for (const ChainResult& c : timing.chains) {
    std::string remark = c.assumed ? "assumed" : "";
    if (c.through_reads) remark += remark.empty() ? "through reads" : ", through reads";
    if (c.closed_form) remark += remark.empty() ? "closed form" : ", closed form";
    table.row({timing.model.devices[c.from].name + " -> " + timing.model.devices[c.to].name, duration_text(c.acquire),
               duration_text(c.decide), duration_text(c.wire), duration_text(c.end_to_end), remark});
  }
  return fmt::format("\nchains (profile {})\n", profile_name(best_profile(timing.model))) + table.text();
}

/// Why a chain shows no bound, once for all of one reason.
std::string missing(const Timing& timing) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (const MissingBound& m : timing.missing) {
    std::string who;
    for (std::size_t i = 0; i < m.chains.size() && i < kMost; ++i) {
      const ChainResult& chain = timing.chains[m.chains[i]];
      who += fmt::format("{}{} -> {}", i > 0 ? ", " : "", timing.model.devices[chain.from].name,
                         timing.model.devices[chain.to].name);
    }
    if (m.chains.size() > kMost) who += fmt::format(" and {} more", m.chains.size() - kMost);
    text += fmt::format("  {} has no bound ({}): {}\n", part_name(m.part), who, m.why);
    for (const std::string& change : m.restored_by) text += fmt::format("    restored by {}\n", change);
  }
  return text;
}

std::string buses(const Timing& timing) {
  const auto& all = timing.model.buses;
  if (std::all_of(all.begin(), all.end(), [](const Bus& bus) { return bus.is_pins; })) return {};
  TextTable table({"bus", "interrupt", "at least every", "wire load"});
  for (const BusPlace b : timing.model.buses.ids()) {
    const Bus& bus = timing.model.buses[b];
    if (bus.is_pins) continue;
    const bool is_known = undeclared_text(timing.model, b).empty();
    table.row({bus.name, duration_text(bus.wcet), duration_text(bus.frame),
               is_known ? percent(timing.bus_loads[b].utilization) : "-"});
  }
  return "\nbuses\n" + table.text();
}

std::string requirements(const Timing& timing) {
  if (timing.requirements.empty()) return {};
  TextTable table({"requirement", "at most", "bound", ""});
  for (const RequirementResult& r : timing.requirements) {
    const bool is_share = r.requirement.kind == Requirement::Kind::utilization;
    table.row({r.requirement.text, is_share ? percent(r.requirement.max_fraction) : duration_text(r.requirement.max),
               r.fraction ? percent(*r.fraction) : duration_text(r.value), r.ok ? "holds" : "fails"});
  }
  return "\nrequirements\n" + table.text();
}

}  // namespace

std::string duration_text(Duration time) {
  struct Scale {
    Duration size;
    std::string_view unit;
  };
  static constexpr Scale kScales[] = {{seconds(1), "s"}, {milliseconds(1), "ms"}, {microseconds(1), "us"}};
  for (const Scale& s : kScales) {
    if (time < s.size) continue;
    const std::int64_t whole = floor_div(time, s.size);
    const std::int64_t thousandths = whole * 1000 + ceil_div((time - whole * s.size) * 1000, s.size);
    std::string digits = fmt::format("{}.{:03}", thousandths / 1000, thousandths % 1000);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return fmt::format("{} {}", digits, s.unit);
  }
  return fmt::format("{} ns", time.ns());
}

std::string duration_text(std::optional<Duration> time) { return time ? duration_text(*time) : "-"; }

std::string timing_table(const Timing& timing) {
  return verdict(timing) + buckets(timing) + processor(timing) + devices(timing) + trees(timing) + chains(timing) +
         missing(timing) + buses(timing) + requirements(timing) + where_assumptions_are() + informative(timing);
}

}  // namespace finemote::gen::timing
