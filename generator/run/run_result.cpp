#include "generator/run/run_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/run/violation.hpp"

namespace finemote::gen {

std::uint64_t RunResult::violations() const {
  std::uint64_t count = 0;
  for (const MonitorEntry& entry : record.monitor) count += entry.response_violations + entry.age_violations;
  return count;
}

std::uint64_t RunResult::overruns() const {
  return std::accumulate(record.overruns.begin(), record.overruns.end(), std::uint64_t{0});
}

namespace {

/// Of a figure that has a bound.
struct Judged {
  Judgement judgement;
  Journey journey;
  bool was_broken;
};

Judged judged_of(const Measured& figure, const Journey& journey) {
  return {figure.judged(), journey, figure.was_broken};
}

std::vector<Judged> judgements(const RunResult& result) {
  std::vector<Judged> all;
  for (const MeasuredChain& chain : result.figures.chains) {
    for (const auto& [name, figure] : kChainFigures) {
      if (chain.has_wire || figure != &MeasuredChain::wire)
        all.push_back(judged_of(chain.*figure, journey_of(chain, figure)));
    }
  }
  for (const MeasuredResponse& response : result.figures.responses) {
    for (const auto& [name, figure] : kResponseFigures) all.push_back(judged_of(response.*figure, {}));
  }
  return all;
}

bool has(const std::vector<Judged>& all, Judgement one) {
  return std::any_of(all.begin(), all.end(), [&](const Judged& judged) { return judged.judgement == one; });
}

/// Broken although nothing that the scenario does takes the ground from its bound, or before it did.
bool is_wrong(const RunResult& result, const Judged& judged) {
  if (judged.judgement != Judgement::broken) return false;
  return judged.was_broken || !violated_assumption(result.robot, result.record.violated, judged.journey);
}

/// A part that is not there answers no transfer; a line that parts send on by themselves is quiet then.
bool is_missed(const Robot& robot, const RunRecord& record, BusId bus) {
  const BusType& type = bus_type(robot.buses[bus].kind);
  return type.bus_class.supervised &&
         std::any_of(record.silent.begin(), record.silent.end(), [&](const std::string& name) {
           return std::any_of(robot.devices.begin(), robot.devices.end(), [&](const Device& device) {
             return device.name.text == name && device.segment && robot.segments[*device.segment].bus == bus;
           });
         });
}

/// As modules of faults are called: kinds of buses with a part that is not there, where no other bus of the kind saw an
/// error.
std::set<std::string> kinds_of_silent_buses(const Robot& robot, const RunRecord& record) {
  std::set<std::string> silent, disturbed;
  for (const BusRecord& bus : record.buses) {
    const std::string kind(bus_type(robot.buses[bus.bus].kind).name);
    if (is_missed(robot, record, bus.bus))
      silent.insert(kind);
    else if (bus.errors > 0)
      disturbed.insert(kind);
  }
  std::erase_if(silent, [&](const std::string& kind) { return disturbed.count(kind) > 0; });
  return silent;
}

}  // namespace

bool RunResult::bounds_hold() const {
  const bool is_monitored_well = (record.violated_from ? record.late_violations : violations()) == 0;
  return is_monitored_well && count_bounds().broken == 0;
}

RunResult::BoundCount RunResult::count_bounds() const {
  BoundCount count;
  for (const Judged& judged : judgements(*this)) {
    const bool is_broken = judged.judgement == Judgement::broken;
    count.judged += is_broken || judged.judgement == Judgement::held ? 1 : 0;
    if (is_broken) ++(is_wrong(*this, judged) ? count.broken : count.excused);
  }
  return count;
}

bool RunResult::claims_hold() const {
  return std::none_of(figures.claims.begin(), figures.claims.end(), [&](const MeasuredClaim& claim) {
    return std::any_of(kClaimFigures.begin(), kClaimFigures.end(), [&](const auto& figure) {
      return is_wrong(*this, judged_of(claim.*figure.measured, {claim.device, {}}));
    });
  });
}

bool RunResult::is_judged() const { return count_bounds().judged > 0; }

bool RunResult::is_all_judged() const {
  const std::vector<Judged> all = judgements(*this);
  const bool are_all_seen = std::none_of(figures.claims.begin(), figures.claims.end(), [](const MeasuredClaim& claim) {
    return claim.age.judged() == Judgement::no_sample;
  });
  return is_judged() && are_all_seen && !has(all, Judgement::no_sample) && !has(all, Judgement::no_bound);
}

std::vector<FaultCount> RunResult::unexplained_faults() const {
  const std::set<std::string> silent = kinds_of_silent_buses(robot, record);
  std::vector<FaultCount> faults;
  for (const FaultCount& fault : record.late_faults) {
    const FaultMeaning* meaning = meaning_of(fault_table, fault);
    if (meaning == nullptr || silent.count(meaning->module_name) == 0) faults.push_back(fault);
  }
  return faults;
}

std::vector<std::string> RunResult::failures() const {
  std::vector<std::string> list;
  const auto add = [&](bool is_so, const char* words) {
    if (is_so) list.emplace_back(words);
  };
  const auto add_number = [&](std::uint64_t number, const char* one, const char* several) {
    if (number > 0) list.push_back(fmt::format("{} {}", number, number == 1 ? one : several));
  };
  const std::size_t broken = count_bounds().broken;
  const auto& expected = record.expectations;
  add(!record.stopped.empty(), "the firmware stopped");
  add(must_judge && !is_judged(), "nothing was judged");
  add_number(broken, "value above its bound", "values above their bounds");
  add(broken == 0 && !bounds_hold(), "the monitor counted values above their bounds");
  add(!claims_hold(), "a false time stamp, or data that are too old");
  add(order.mistake.has_value(), "a stage out of its order");
  add_number(overruns(), "overrun", "overruns");
  add_number(record.resets, "reset", "resets");
  add(!declared_hold, "a declared execution time below its bound");
  add(!wcets_hold, "an execution time above its WCET");
  add(!loops_hold, "a loop with more iterations than its mark says");
  add(!traffic_holds, "more traffic than is declared");
  add_number(unexplained_faults().size(), "fault that no scenario asked for", "faults that no scenario asked for");
  add_number(std::count_if(expected.begin(), expected.end(), [](const ExpectationRecord& e) { return !e.ok; }),
             "expectation not met", "expectations not met");
  return list;
}

const std::string& name_of(const RunResult& result, DeviceId device) { return result.robot.devices[device].name.text; }

}  // namespace finemote::gen
