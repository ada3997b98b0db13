#include "generator/run/record.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

void add(std::vector<OwnTime>& all, const OwnTime& more) {
  for (OwnTime& own : all) {
    if (own.device != more.device || own.is_handle != more.is_handle) continue;
    own.longest = std::max(own.longest, more.longest);
    return;
  }
  all.push_back(more);
}

void add(std::vector<RoutineTime>& all, const RoutineTime& more) {
  for (RoutineTime& routine : all) {
    if (routine.exception != more.exception) continue;
    routine.longest = std::max(routine.longest, more.longest);
    routine.runs = std::max(routine.runs, more.runs);
    return;
  }
  all.push_back(more);
}

void add(std::vector<FaultCount>& all, const FaultCount& more) {
  for (FaultCount& fault : all) {
    if (fault.module != more.module || fault.number != more.number) continue;
    fault.count += more.count;
    return;
  }
  all.push_back(more);
}

void add(MonitorEntry& all, const MonitorEntry& more) {
  all.response_max = std::max(all.response_max, more.response_max);
  all.age_max = std::max(all.age_max, more.age_max);
  all.response_violations += more.response_violations;
  all.age_violations += more.age_violations;
}

}  // namespace

void merge(RunRecord& all, const RunRecord& more) {
  for (const OwnTime& own : more.own_times) add(all.own_times, own);
  for (const RoutineTime& routine : more.routine_times) add(all.routine_times, routine);
  for (std::size_t i = 0; i < all.loop_passes.size() && i < more.loop_passes.size(); ++i)
    all.loop_passes[i] = std::max(all.loop_passes[i], more.loop_passes[i]);
  for (const FaultCount& fault : more.faults) add(all.faults, fault);
  for (const FaultCount& fault : more.late_faults) add(all.late_faults, fault);
  for (std::size_t i = 0; i < all.overruns.size() && i < more.overruns.size(); ++i) all.overruns[i] += more.overruns[i];
  for (std::size_t i = 0; i < all.monitor.size() && i < more.monitor.size(); ++i) add(all.monitor[i], more.monitor[i]);
  for (std::size_t i = 0; i < all.expectations.size() && i < more.expectations.size(); ++i) {
    if (all.expectations[i].ok && !more.expectations[i].ok) all.expectations[i] = more.expectations[i];
  }
  for (const std::string& part : more.absent) {
    if (std::find(all.absent.begin(), all.absent.end(), part) == all.absent.end()) all.absent.push_back(part);
  }
  for (std::size_t i = 0; i < all.buses.size() && i < more.buses.size(); ++i)
    all.buses[i].errors = std::max(all.buses[i].errors, more.buses[i].errors);
  if (all.stopped.empty()) all.stopped = more.stopped;
  all.resets += more.resets;
  all.scripted_resets += more.scripted_resets;
  all.late_violations += more.late_violations;
}

}  // namespace finemote::gen
