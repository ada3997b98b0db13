#include "generator/descriptor/costs.hpp"

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

std::optional<Duration> cost(const Json& costs, const char* name, CodePlace place) {
  const auto found = costs.find(name);
  if (found == costs.end() || found->is_null()) return {};
  const auto in_sram = duration_member(*found, "sram_ns");
  return place == CodePlace::sram && in_sram ? in_sram : duration_member(*found, "ns");
}

}  // namespace

Costs read_costs(const Json& value, CodePlace place) {
  const auto required = [&](const char* name) { return cost(value, name, place).value_or(Duration::zero()); };
  Costs costs;
  costs.release = required("release");
  costs.release_per_bucket = required("release_per_bucket");
  costs.release_walk = required("release_walk");
  costs.release_walk_per_bucket = required("release_walk_per_bucket");
  costs.exception_entry = required("exception_entry");
  costs.exception_exit = required("exception_exit");
  costs.fpu_context = required("fpu_context");
  costs.preemption = required("preemption");
  costs.bucket = required("bucket");
  costs.stage = required("stage");
  costs.masked_section = required("masked_section");
  costs.event_entry = cost(value, "event_entry", place);
  costs.event_pause = cost(value, "event_pause", place);
  costs.flush = required("flush");
  costs.flush_per_channel = required("flush_per_channel");
  costs.flush_expander = required("flush_expander");
  costs.flush_expander_per_channel = required("flush_expander_per_channel");
  costs.latch = required("latch");
  costs.latch_per_word = required("latch_per_word");
  costs.trace_event = required("trace_event");
  costs.monitor_handle = cost(value, "monitor_handle", place);
  costs.monitor_job = cost(value, "monitor_job", place);
  return costs;
}

}  // namespace finemote::gen
