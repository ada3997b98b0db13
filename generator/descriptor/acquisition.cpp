#include "generator/descriptor/acquisition.hpp"

#include <algorithm>

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

Conversion read_conversion(const Json& value) {
  Conversion conversion;
  conversion.fixed = duration_member(value, "ns").value_or(Duration::zero());
  conversion.param = value.value("param", std::string());
  if (const auto times = value.find("ns_by_value"); times != value.end()) {
    for (const auto& [text, ns] : times->items()) conversion.by_value[text] = nanoseconds(ns.get<std::int64_t>());
  }
  return conversion;
}

}  // namespace

Duration Conversion::longest() const {
  Duration longest = param.empty() ? fixed : Duration::zero();
  for (const auto& [value, time] : by_value) longest = std::max(longest, time);
  return longest;
}

Acquisition read_acquisition(const Json& value) {
  Acquisition acquisition;
  const auto model = value.at("model").get<std::string>();
  acquisition.model = model == "streamed" ? Acquisition::Model::streamed : Acquisition::Model::polled;
  acquisition.latency = duration_member(value, "latency_ns").value_or(Duration::zero());
  acquisition.interval = duration_member(value, "interval_ns");
  acquisition.interval_param = value.value("interval_param", std::string());
  acquisition.tolerance_ppm = value.value("tolerance_ppm", acquisition.tolerance_ppm);
  acquisition.periods = optional_member<std::int64_t>(value, "periods");
  acquisition.begun_every = optional_member<std::int64_t>(value, "begun_every");
  acquisition.conversions = value.value("conversions", std::int64_t{1});
  acquisition.published_every = value.value("published_every", std::int64_t{1});
  acquisition.bring_up = duration_member(value, "bring_up_ns").value_or(acquisition.bring_up);
  if (const auto conversion = value.find("conversion"); conversion != value.end())
    acquisition.conversion = read_conversion(*conversion);
  return acquisition;
}

}  // namespace finemote::gen
