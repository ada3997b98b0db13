#include "generator/run/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "generator/schedule/period.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

// For people, and for the viewers of traces.
double microseconds_of(Duration time) { return static_cast<double>(time.ns()) / 1e3; }
double milliseconds_of(Duration time) { return static_cast<double>(time.ns()) / 1e6; }

const std::string& name_of(const RunResult& result, DeviceId device) { return result.robot.devices[device].name.text; }

Json statistics(const Measured& figure) {
  const Statistics& s = figure.observed;
  const bool any = s.count > 0;
  return {{"min_ns", any ? Json(s.min.ns()) : Json(nullptr)},
          {"mean_ns", any ? Json(s.mean_ns) : Json(nullptr)},
          {"sd_ns", any ? Json(s.sd_ns) : Json(nullptr)},
          {"max_ns", any ? Json(s.max.ns()) : Json(nullptr)},
          {"bound_ns", figure.bound ? Json(figure.bound->ns()) : Json(nullptr)}};
}

Json stage_list(const RunResult& result) {
  Json list = Json::array();
  for (DeviceId device : result.forest.order) {
    for (const bool is_handle : {false, true}) {
      const Statistics s = summarize(stage_times(result.record, device, is_handle));
      const bool any = s.count > 0;
      list.push_back({{"device", name_of(result, device)},
                      {"stage", is_handle ? "handle" : "update"},
                      {"count", s.count},
                      {"min_ns", any ? Json(s.min.ns()) : Json(nullptr)},
                      {"mean_ns", any ? Json(s.mean_ns) : Json(nullptr)},
                      {"max_ns", any ? Json(s.max.ns()) : Json(nullptr)}});
    }
  }
  return list;
}

Json event_list(const RunResult& result) {
  Json list = Json::array();
  for (const Event& event : result.record.events) {
    if (event.at >= result.shown) break;
    list.push_back({{"t_ns", event.at.ns()},
                    {"device", name_of(result, event.device)},
                    {"stage", event.is_handle ? "handle" : "update"},
                    {"edge", event.is_end ? "end" : "begin"}});
  }
  return list;
}

Json chain_list(const RunResult& result) {
  Json list = Json::array();
  for (const MeasuredChain& chain : result.chains) {
    list.push_back({{"from", name_of(result, chain.from)},
                    {"to", name_of(result, chain.to)},
                    {"samples", chain.decide.observed.count},
                    {"decide", statistics(chain.decide)},
                    {"acquire", statistics(chain.acquire)},
                    {"wire", statistics(chain.wire)},
                    {"end_to_end", statistics(chain.end_to_end)}});
  }
  return list;
}

Json bus_list(const RunResult& result) {
  Json list = Json::array();
  for (const BusRecord& bus : result.record.buses) {
    if (!result.robot.buses.contains(bus.bus)) continue;
    list.push_back({{"name", result.robot.buses[bus.bus].name.text},
                    {"transfers", bus.transfers},
                    {"errors", bus.errors},
                    {"busy", bus.busy}});
  }
  return list;
}

Json bound(std::optional<Duration> time) { return time ? Json(time->ns()) : Json(nullptr); }

Json monitor_list(const RunResult& result) {
  Json list = Json::array();
  for (const MonitorEntry& entry : result.record.monitor) {
    const timing::DeviceBounds& of = result.bounds.devices[entry.device];
    list.push_back({{"device", name_of(result, entry.device)},
                    {"response_max_ns", entry.response_max.ns()},
                    {"response_bound_ns", bound(of.response)},
                    {"age_max_ns", entry.age_max > Duration::zero() ? Json(entry.age_max.ns()) : Json(nullptr)},
                    {"age_bound_ns", bound(of.age)},
                    {"response_violations", entry.response_violations},
                    {"age_violations", entry.age_violations}});
  }
  return list;
}

Json expectation_list(const RunResult& result) {
  Json list = Json::array();
  for (const ExpectationRecord& e : result.record.expectations) {
    list.push_back({{"part", e.part},
                    {"value", e.value},
                    {"from_ns", e.from.ns()},
                    {"to_ns", e.to.ns()},
                    {"min", e.min},
                    {"max", e.max},
                    {"lowest", e.lowest ? Json(*e.lowest) : Json(nullptr)},
                    {"highest", e.highest ? Json(*e.highest) : Json(nullptr)},
                    {"finite", e.finite},
                    {"ok", e.ok}});
  }
  return list;
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

void print_figure(const RunResult& result, const MeasuredChain& chain, const char* part, const Measured& figure,
                  std::ostream& out) {
  const Statistics& s = figure.observed;
  if (s.count == 0) return;
  const std::string name = name_of(result, chain.from) + " -> " + name_of(result, chain.to);
  out << fmt::format("  {:<28} {:<10} {:>7} {:>11.3f} {:>11.3f} {:>11.3f} {:>9.3f} {:>11}{}\n", name, part, s.count,
                     microseconds_of(s.min), s.mean_ns / 1e3, microseconds_of(s.max), s.sd_ns / 1e3,
                     figure.bound ? fmt::format("{:.3f}", microseconds_of(*figure.bound)) : "-",
                     figure.holds() ? "" : "  ABOVE ITS BOUND");
}

/// In QEMU every instruction takes 8 ns, so times of a busy processor are counts.
void print_instructions(const RunResult& result, std::ostream& out) {
  if (!result.record.instruction_time) return;
  const Duration each = *result.record.instruction_time;
  out << "\nthe same in instructions: update to handle\n";
  for (const MeasuredChain& chain : result.chains) {
    const Statistics& s = chain.decide.observed;
    if (s.count == 0) continue;
    out << fmt::format("  {:<28} {} to {}, jitter {}\n",
                       name_of(result, chain.from) + " -> " + name_of(result, chain.to), floor_div(s.min, each),
                       floor_div(s.max, each), floor_div(s.max - s.min, each));
  }
}

void print_chains(const RunResult& result, std::ostream& out) {
  out << "\nage of the data behind a command, us: sample (acquire) update (decide) handle (wire) output\n";
  out << fmt::format("  {:<28} {:<10} {:>7} {:>11} {:>11} {:>11} {:>9} {:>11}\n", "chain", "part", "samples", "min",
                     "mean", "max", "sd", "bound");
  for (const MeasuredChain& chain : result.chains) {
    print_figure(result, chain, "acquire", chain.acquire, out);
    print_figure(result, chain, "decide", chain.decide, out);
    print_figure(result, chain, "wire", chain.wire, out);
    print_figure(result, chain, "end to end", chain.end_to_end, out);
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
  out << "\nmeasured here, of devices whose execution times are assumed: the longest run seen and a quarter\n";
  for (const MeasuredWcet& wcet : result.wcets)
    out << fmt::format("  {:<28} {}\n", name_of(result, wcet.device), wcet_element(wcet));
}

}  // namespace

std::uint64_t RunResult::violations() const {
  std::uint64_t count = 0;
  for (const MonitorEntry& entry : record.monitor) count += entry.response_violations + entry.age_violations;
  return count;
}

std::uint64_t RunResult::overruns() const {
  return std::accumulate(record.overruns.begin(), record.overruns.end(), std::uint64_t{0});
}

bool RunResult::good() const {
  const bool bounds_hold = std::all_of(chains.begin(), chains.end(), [](const MeasuredChain& c) { return c.holds(); });
  const auto& expected = record.expectations;
  const bool as_expected =
      std::all_of(expected.begin(), expected.end(), [](const ExpectationRecord& e) { return e.ok; });
  return overruns() == 0 && record.resets == 0 && ((violations() == 0 && bounds_hold) || record.faulty) && as_expected;
}

Json run_document(const RunResult& result) {
  const bool is_arm = result.image.flash > 0;
  Json document = {{"schema", "finemote.run/1"},
                   {"image",
                    {{"sha256", result.image.sha256},
                     {"flash", is_arm ? Json(result.image.flash) : Json(nullptr)},
                     {"ram", is_arm ? Json(result.image.ram) : Json(nullptr)},
                     {"stack", result.image.stack ? Json(*result.image.stack) : Json(nullptr)}}},
                   {"board", result.board},
                   {"duration_ns", result.duration.ns()},
                   {"stages", stage_list(result)},
                   {"events", event_list(result)},
                   {"chains", chain_list(result)},
                   {"overruns", result.overruns()},
                   {"resets", result.record.resets},
                   {"buses", bus_list(result)},
                   {"flash", result.record.flash.empty() ? Json(nullptr) : Json(result.record.flash)},
                   {"faults", result.record.faulty},
                   {"expectations", expectation_list(result)},
                   {"silent", result.record.silent},
                   {"schedulable", result.schedulable ? Json(*result.schedulable) : Json(nullptr)}};
  if (!result.record.monitor.empty()) document["monitor"] = monitor_list(result);
  return document;
}

void print_image(const ImageFacts& image, std::ostream& out) {
  if (image.flash == 0) return;
  out << fmt::format("flash {} B, RAM {} B, stack {}\n", image.flash, image.ram,
                     image.stack ? fmt::format("{} B (proven worst case)", *image.stack) : "without bound");
}

void print_run(const RunResult& result, std::ostream& out) {
  out << fmt::format("{} on {}, {}\n", result.robot.name.text, result.board, period_text(result.duration));
  print_image(result.image, out);
  if (!result.record.flash.empty())
    out << fmt::format("times are derived from instructions; fetches from flash {}\n",
                       result.record.flash == "hit" ? "hit its accelerator" : "always miss its accelerator");
  if (result.record.flash == "miss")
    out << "bounds are those of the execution times that are declared or assumed, whatever the fetches cost\n";
  print_order(result, out);
  print_chains(result, out);
  print_monitor(result, out);
  print_instructions(result, out);
  if (!result.record.buses.empty()) out << "\nbuses\n";
  for (const BusRecord& bus : result.record.buses) {
    if (!result.robot.buses.contains(bus.bus)) continue;
    out << fmt::format("  {:<12} {:>7} transfers {:>4} errors  busy {:.1f} %\n", result.robot.buses[bus.bus].name.text,
                       bus.transfers, bus.errors, 100 * bus.busy);
  }
  if (result.record.faulty) out << "\nthe scenario injects faults: bounds are shown, not judged\n";
  print_expectations(result, out);
  print_wcets(result, out);
  for (const std::string& device : result.record.silent)
    out << fmt::format("\nnote: the emulated board has no model of '{}': its bus is silent\n", device);
  out << fmt::format("\noverruns {}, resets {}\n", result.overruns(), result.record.resets);
  if (result.schedulable)
    out << fmt::format("schedulable: {} (finemote analyze)\n", *result.schedulable ? "yes" : "no");
  for (const FaultCount& fault : result.record.faults)
    out << "fault: " << fault_text(result.fault_table, fault) << "\n";
}

Json run_trace(const RunResult& result) {
  Json events = Json::array();
  const auto slice = [&](DeviceId device, bool is_handle, Duration begin, Duration end) {
    events.push_back({{"name", name_of(result, device) + (is_handle ? ".handle" : ".update")},
                      {"ph", "X"},
                      {"pid", 1},
                      {"tid", result.schedule.bucket_of[device] + 1},
                      {"ts", microseconds_of(begin)},
                      {"dur", microseconds_of(end - begin)}});
  };
  for (std::size_t i = 0; i < result.schedule.buckets.size(); ++i) {
    events.push_back({{"name", "thread_name"},
                      {"ph", "M"},
                      {"pid", 1},
                      {"tid", i + 1},
                      {"args", {{"name", "every " + period_text(result.schedule.buckets[i].period)}}}});
  }
  struct Running {
    DeviceId device;
    bool is_handle;
    Duration since;
  };
  std::vector<Running> stack;
  for (const Event& event : result.record.events) {
    if (!stack.empty()) slice(stack.back().device, stack.back().is_handle, stack.back().since, event.at);
    if (!event.is_end) {
      stack.push_back({event.device, event.is_handle, event.at});
    } else if (!stack.empty()) {
      stack.pop_back();
      if (!stack.empty()) stack.back().since = event.at;
    }
  }
  return {{"traceEvents", events}, {"displayTimeUnit", "ns"}};
}

}  // namespace finemote::gen
