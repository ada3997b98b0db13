#include "generator/timing/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

using units::readable_duration;

constexpr double kGoodBusLoad = 0.7;  ///< what hints aim at: that of lint

/// Percent, rounded up so far that reading it again gives no less than `fraction`.
std::string percent_text(double fraction) {
  std::string text = fmt::format("{:.2f}", std::ceil(fraction * 1e4) / 100);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text + "%";
}

std::string whole_percent(double fraction) { return fmt::format("{:.0f} %", fraction * 100); }
std::string tenths_percent(double fraction) { return fmt::format("{:.1f} %", fraction * 100); }
std::string quoted(const std::string& name) { return "'" + name + "'"; }

/// Somebody's part of a load.
struct Share {
  std::string who;  ///< `'imu'`, `'thruster_1' and 7 more`
  double load = 0;
  bool autonomous = false;  ///< sent by the part itself, not by its device
};

void add_share(std::vector<Share>& shares, const std::string& who, double load, bool autonomous) {
  const auto known = std::find_if(shares.begin(), shares.end(),
                                  [&](const Share& s) { return s.who == who && s.autonomous == autonomous; });
  if (known == shares.end()) return shares.push_back({who, load, autonomous});
  known->load += load;
}

double ratio(Ns part, Ns whole) { return static_cast<double>(part) / static_cast<double>(std::max<Ns>(whole, 1)); }

/// Who asks for the time of a bus (of its busier line), largest first.
std::vector<Share> bus_shares(const Model& model, std::size_t bus) {
  std::vector<Share> lines[2];
  for (const Device& device : model.devices) {
    for (const Transfer& t : device.transfers) {
      if (t.bus != bus) continue;
      const bool autonomous = t.after == Transfer::After::autonomous;
      const Ns period = autonomous && t.min_interval_ns > 0 ? t.min_interval_ns : device.period_ns;
      add_share(lines[t.receive ? 1 : 0], quoted(device.name), ratio(t.wire_ns, period), autonomous);
    }
  }
  for (const Flush& flush : model.flushes) {
    if (flush.bus != bus || flush.devices.empty()) continue;
    const std::string more = flush.devices.size() > 1 ? fmt::format(" and {} more", flush.devices.size() - 1) : "";
    add_share(lines[0], quoted(model.devices[flush.devices.front()].name) + more, ratio(flush.wire_ns, flush.period_ns),
              false);
  }
  const auto sum = [](const std::vector<Share>& shares) {
    double load = 0;
    for (const Share& share : shares) load += share.load;
    return load;
  };
  std::vector<Share>& busier = lines[sum(lines[1]) > sum(lines[0]) ? 1 : 0];
  std::stable_sort(busier.begin(), busier.end(), [](const Share& a, const Share& b) { return a.load > b.load; });
  return busier;
}

std::string shares_text(const std::vector<Share>& shares) {
  constexpr std::size_t kMost = 12;
  std::string text;
  for (std::size_t i = 0; i < shares.size() && i < kMost; ++i) {
    text += fmt::format("{}{}{}: {}", i > 0 ? ", " : "", shares[i].who, shares[i].autonomous ? " by itself" : "",
                        tenths_percent(shares[i].load));
  }
  if (shares.size() > kMost) text += fmt::format(" and {} more", shares.size() - kMost);
  return text;
}

/// What makes room on a bus: fewer messages, a faster bus, another bus.
void add_room_hints(const Timing& timing, std::size_t index, Diagnostic& finding, double wanted = kGoodBusLoad) {
  const Bus& bus = timing.model.buses[index];
  const double load = timing.bus_loads[index].utilization;
  const std::vector<Share> shares = bus_shares(timing.model, index);
  double fixed = 0;  // what the parts send by themselves, whatever the periods of their devices
  for (const Share& share : shares) fixed += share.autonomous ? share.load : 0;
  const double ours = load - fixed;
  if (ours > 0 && fixed < wanted) {
    const double factor = std::max(2.0, std::ceil(ours / (wanted - fixed)));
    finding.hint(fmt::format("longer periods of the devices on it: {:.0f} times as long is {}", factor,
                             whole_percent(fixed + ours / factor)));
  } else {
    const double factor = std::max(2.0, std::ceil(fixed / std::max(wanted - ours, wanted / 2)));
    finding.hint(
        fmt::format("set the parts themselves, not this file, to send less often: {:.0f} times as rarely is {}", factor,
                    whole_percent(ours + fixed / factor)));
  }
  const auto load_at = [&](const BusAdvice::Rate& rate) { return load * ratio(bus.baud_bps, rate.bps); };
  for (const BusAdvice::Rate& rate : bus.advice.rates) {
    if (load_at(rate) > wanted && rate.bps != bus.advice.rates.back().bps) continue;
    finding.hint(fmt::format("write {}, which is about {}", rate.text, whole_percent(load_at(rate))));
    break;
  }
  const std::string busiest = shares.empty() ? std::string() : shares.front().who;
  const bool is_alone = std::all_of(shares.begin(), shares.end(), [&](const Share& s) { return s.who == busiest; });
  if (is_alone) return;
  finding.hint(fmt::format("move devices, {} first, to another bus{}", busiest,
                           bus.advice.other_port.empty() ? "" : ": " + bus.advice.other_port));
}

/// The bus something goes over; none where its output is a pin of the chip.
std::optional<std::size_t> command_bus(const Model& model, std::size_t to) {
  for (const Transfer& t : model.devices[to].transfers) {
    if (t.command) return t.bus;
  }
  for (const Flush& flush : model.flushes) {
    if (flush.bus && std::find(flush.devices.begin(), flush.devices.end(), to) != flush.devices.end()) return flush.bus;
  }
  return std::nullopt;
}

std::optional<std::size_t> sample_bus(const Model& model, std::size_t from) {
  for (const Transfer& t : model.devices[from].transfers) {
    if (!t.command) return t.bus;
  }
  return std::nullopt;
}

/// The devices between both ends and the root, ends included.
std::vector<std::size_t> devices_between(const Model& model, const ChainResult& chain) {
  std::vector<std::size_t> way;
  for (std::optional<std::size_t> d = chain.from; d; d = model.devices[*d].parent) way.push_back(*d);
  for (std::optional<std::size_t> d = chain.to; d; d = model.devices[*d].parent) way.push_back(*d);
  return way;
}

/// Says which part of a chain is the largest, and what shortens it.
class ChainExplainer {
 public:
  ChainExplainer(const Timing& timing, const ChainResult& chain, Diagnostic& finding)
      : timing_(timing), model_(timing.model), chain_(chain), finding_(finding) {}

  void explain(bool decision_only) {
    const std::string &from = model_.devices[chain_.from].name, &to = model_.devices[chain_.to].name;
    if (!decision_only) {
      finding_.note(fmt::format("acquire {} + decide {} + wire {}, from '{}' to '{}'", text(chain_.acquire_ns),
                                text(chain_.decide_ns), text(chain_.wire_ns), from, to));
    }
    const auto is_largest = [&](std::optional<Ns> part) {
      return part ==
             std::max({chain_.acquire_ns.value_or(0), chain_.decide_ns.value_or(0), chain_.wire_ns.value_or(0)});
    };
    if (decision_only || !chain_.decide_ns) return explain_decide();
    if (!chain_.acquire_ns) return explain_unbounded("acquire", sample_bus(model_, chain_.from));
    if (!chain_.wire_ns) return explain_unbounded("wire", command_bus(model_, chain_.to));
    if (is_largest(chain_.decide_ns)) return explain_decide("decide is the largest part: ");
    if (is_largest(chain_.acquire_ns)) return explain_acquire();
    explain_wire();
  }

 private:
  static std::string text(std::optional<Ns> ns) { return ns ? readable_duration(*ns) : "without bound"; }

  void explain_unbounded(const char* part, std::optional<std::size_t> bus) {
    if (!bus) return;
    finding_.note(
        fmt::format("{}: on bus '{}' a message may still wait when the next one is due; it is asked for {} "
                    "of its time",
                    part, model_.buses[*bus].name, whole_percent(timing_.bus_loads[*bus].utilization)));
    if (timing_.bus_loads[*bus].utilization <= 1) add_room_hints(timing_, *bus, finding_);  // else FM4021 has them
  }
  void explain_acquire() {
    const Device& device = model_.devices[chain_.from];
    const bool streams = device.acquisition && device.acquisition->periods == 0;
    if (streams) {
      finding_.note(fmt::format("acquire is the largest part: how old what '{}' sends can be", device.name));
      finding_.hint(fmt::format("let '{}' send more often, or over a faster bus", device.name));
      return;
    }
    finding_.note(fmt::format("acquire is the largest part: {} periods of '{}' ({}) for one measurement",
                              std::max<Ns>(*chain_.acquire_ns / device.period_ns, 1), device.name,
                              readable_duration(device.period_ns)));
    const bool converts = device.acquisition && device.acquisition->conversion_ns > 0;
    finding_.hint(fmt::format("shorten the period of '{}'{}", device.name, converts ? " or its conversion" : ""));
  }
  void explain_wire() {
    const auto bus = command_bus(model_, chain_.to);
    const std::string& to = model_.devices[chain_.to].name;
    if (!bus) {
      finding_.note(fmt::format("wire is the largest part: the output of '{}' itself", to));
      return;
    }
    finding_.note(fmt::format("wire is the largest part: the command of '{}' goes over bus '{}', busy for {}", to,
                              model_.buses[*bus].name, whole_percent(timing_.bus_loads[*bus].utilization)));
    const BusAdvice& advice = model_.buses[*bus].advice;
    if (!advice.rates.empty()) finding_.hint(fmt::format("write {} at the bus", advice.rates.back().text));
    if (!advice.other_port.empty())
      finding_.hint("move what need not be on this bus to another one: " + advice.other_port);
  }
  void explain_decide(const char* decide = "") {
    if (!chain_.decide_ns) {
      finding_.note("decide has no bound: devices on the way may not be ready when they are due again");
      return;
    }
    const std::vector<std::size_t> way = devices_between(model_, chain_);
    const auto period = [&](std::size_t d) { return model_.devices[d].period_ns; };
    const auto [fastest, slowest] = std::minmax_element(
        way.begin(), way.end(), [&](std::size_t a, std::size_t b) { return period(a) < period(b); });
    if (*chain_.decide_ns >= period(*fastest)) {  // waiting for the next job, more than working
      finding_.note(fmt::format("{}'{}' runs every {}, the slowest on the way", decide, model_.devices[*slowest].name,
                                readable_duration(period(*slowest))));
      finding_.hint(fmt::format("shorten the period of '{}'", model_.devices[*slowest].name));
      return;
    }
    const Device& device = model_.devices[busiest_within(period(*slowest))];
    finding_.note(fmt::format("{}of what runs every {} or more often, '{}' takes longest: update {}, handle {}", decide,
                              readable_duration(period(*slowest)), device.name,
                              readable_duration(device.update_wcet_ns), readable_duration(device.handle_wcet_ns)));
    finding_.hint(
        fmt::format("shorten the work of '{}', or give what this chain does not need a longer period", device.name));
  }
  [[nodiscard]] std::size_t busiest_within(Ns period) const {
    std::size_t busiest = chain_.from;
    Ns most = -1;
    for (std::size_t d = 0; d < model_.devices.size(); ++d) {
      const Device& device = model_.devices[d];
      if (device.period_ns > period || add(device.update_wcet_ns, device.handle_wcet_ns) <= most) continue;
      most = add(device.update_wcet_ns, device.handle_wcet_ns);
      busiest = d;
    }
    return busiest;
  }

  const Timing& timing_;
  const Model& model_;
  const ChainResult& chain_;
  Diagnostic& finding_;
};

const char* subject(Requirement::Kind kind) {
  switch (kind) {
    case Requirement::Kind::latency_end_to_end:
      return "latency";
    case Requirement::Kind::latency_decision:
      return "decision latency";
    case Requirement::Kind::utilization:
      return "utilization";
    case Requirement::Kind::jitter:
      return "jitter";
  }
  return "";
}

std::string message_of(const RequirementResult& r) {
  const std::string what = fmt::format("{} of '{}'", subject(r.requirement.kind), r.requirement.text);
  if (r.fraction) {
    return fmt::format("{} is up to {}, above its max of {}", what, percent_text(*r.fraction),
                       percent_text(r.requirement.max_fraction));
  }
  const std::string max = readable_duration(r.requirement.max_ns);
  return r.value_ns ? fmt::format("{} is up to {}, above its max of {}", what, readable_duration(*r.value_ns), max)
                    : fmt::format("{} has no bound, its max is {}", what, max);
}

void explain_utilization(const Timing& timing, const RequirementResult& r, Diagnostic& finding) {
  std::vector<Share> shares;
  if (r.requirement.bus) {
    shares = bus_shares(timing.model, *r.requirement.bus);
    finding.note(shares_text(shares));
    add_room_hints(timing, *r.requirement.bus, finding, r.requirement.max_fraction);
    return;
  }
  double devices = 0;
  for (const Device& device : timing.model.devices) {
    const double load = ratio(add(device.update_wcet_ns, device.handle_wcet_ns), device.period_ns);
    add_share(shares, quoted(device.name), load, false);
    devices += load;
  }
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.load > b.load; });
  finding.note(shares_text(shares));
  const double others = *r.fraction - devices;
  finding.note(fmt::format("interrupts of buses, releases and copies take {}", tenths_percent(others)));
  if (others > devices) {
    finding.hint("a lower rate of the busiest bus, or measured isr_wcet and min_frame at it, makes interrupts less");
  } else if (!shares.empty()) {
    finding.hint(fmt::format("give {} a longer period or less work", shares.front().who));
  }
}

void explain(const Timing& timing, const RequirementResult& r, Diagnostic& finding) {
  using Kind = Requirement::Kind;
  if (r.unconnected) {
    finding.note(fmt::format("no data leads from '{}' to '{}'", timing.model.devices[r.unconnected->from].name,
                             timing.model.devices[r.unconnected->to].name));
    finding.hint("write it the other way round, or join their trees with <reads>");
    return;
  }
  if (r.requirement.kind == Kind::utilization) return explain_utilization(timing, r, finding);
  if (r.requirement.kind == Kind::jitter) {
    const Device& device = timing.model.devices[r.requirement.to.front()];
    finding.note("jitter is from the earliest to the latest end of its handle() after a release");
    finding.hint(fmt::format(
        "shorten what can come before the handle() of '{}': faster periods, interrupts, its bucket", device.name));
    return;
  }
  if (!r.chain) return;
  ChainExplainer(timing, *r.chain, finding).explain(r.requirement.kind == Kind::latency_decision);
  const bool decision_holds =
      r.requirement.kind == Kind::latency_end_to_end && r.decide_ns && *r.decide_ns <= r.requirement.max_ns;
  if (decision_holds) {
    finding.hint(fmt::format("of=\"decision\" holds: update of the one to handle of the other takes {}",
                             readable_duration(*r.decide_ns)));
  }
}

}  // namespace

void report_requirements(const Timing& timing, Diagnostics& diagnostics) {
  for (const RequirementResult& r : timing.requirements) {
    if (r.ok) continue;
    Diagnostic& finding = diagnostics.error(code::timing_requirement, r.requirement.at, message_of(r));
    finding.underline(8);
    explain(timing, r, finding);
    if (r.value_ns)
      finding.hint(fmt::format("max=\"{}\" is the smallest that holds today", readable_duration(*r.value_ns)));
    if (r.fraction) finding.hint(fmt::format("max=\"{}\" is the smallest that holds today", percent_text(*r.fraction)));
  }
}

void report_bus_overloads(const Timing& timing, Diagnostics& diagnostics) {
  for (std::size_t b = 0; b < timing.bus_loads.size(); ++b) {
    const double load = timing.bus_loads[b].utilization;
    if (load <= 1) continue;
    Diagnostic& finding = diagnostics.warning(
        code::timing_bus_overload, timing.model.buses[b].at,
        fmt::format("bus '{}' is asked for {} of its time", timing.model.buses[b].name, whole_percent(load)));
    finding.underline(4).note(shares_text(bus_shares(timing.model, b)));
    finding.note("messages are left out or late, and no latency over it has a bound");
    add_room_hints(timing, b, finding);
  }
}

}  // namespace finemote::gen::timing
