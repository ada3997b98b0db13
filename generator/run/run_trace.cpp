#include "generator/run/run_trace.hpp"

#include "generator/forest/stage.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

double trace_time(Duration time) { return static_cast<double>(time.ns()) / 1e3; }

}  // namespace

Json run_trace(const RunResult& result) {
  Json events = Json::array();
  const auto slice = [&](DeviceId device, bool is_handle, Duration begin, Duration end) {
    events.push_back({{"name", name_of(result, device) + "." + stage_name(is_handle)},
                      {"ph", "X"},
                      {"pid", 1},
                      {"tid", result.schedule.bucket_of[device] + 1},
                      {"ts", trace_time(begin)},
                      {"dur", trace_time(end - begin)}});
  };
  for (std::size_t i = 0; i < result.schedule.buckets.size(); ++i) {
    events.push_back({{"name", "thread_name"},
                      {"ph", "M"},
                      {"pid", 1},
                      {"tid", i + 1},
                      {"args", {{"name", "every " + units::spaced_duration(result.schedule.buckets[i].period)}}}});
    events.push_back(
        {{"name", "thread_sort_index"}, {"ph", "M"}, {"pid", 1}, {"tid", i + 1}, {"args", {{"sort_index", i + 1}}}});
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
