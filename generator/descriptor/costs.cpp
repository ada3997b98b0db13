#include "generator/descriptor/costs.hpp"

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

std::optional<std::int64_t> cost(const Json& costs, const char* name) {
  const auto found = costs.find(name);
  if (found == costs.end() || found->is_null()) return {};
  return found->value("ns", std::int64_t{0});
}

}  // namespace

Costs read_costs(const Json& value) {
  const auto required = [&](const char* name) { return cost(value, name).value_or(0); };
  Costs costs;
  costs.release_ns = required("release");
  costs.release_per_bucket_ns = required("release_per_bucket");
  costs.exception_entry_ns = required("exception_entry");
  costs.exception_exit_ns = required("exception_exit");
  costs.bucket_ns = required("bucket");
  costs.stage_ns = required("stage");
  costs.masked_section_ns = required("masked_section");
  costs.flush_ns = required("flush");
  costs.flush_per_channel_ns = required("flush_per_channel");
  costs.latch_ns = required("latch");
  costs.latch_per_word_ns = required("latch_per_word");
  costs.trace_event_ns = required("trace_event");
  costs.monitor_handle_ns = cost(value, "monitor_handle");
  costs.monitor_job_ns = cost(value, "monitor_job");
  return costs;
}

}  // namespace finemote::gen
