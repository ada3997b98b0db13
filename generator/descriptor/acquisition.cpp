#include "generator/descriptor/acquisition.hpp"

#include <algorithm>

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

Conversion read_conversion(const Json& value) {
  Conversion conversion;
  conversion.fixed_ns = value.value("ns", std::int64_t{0});
  conversion.param = value.value("param", std::string());
  conversion.ns_by_value = value.value("ns_by_value", conversion.ns_by_value);
  return conversion;
}

}  // namespace

std::int64_t Conversion::longest_ns() const {
  std::int64_t longest = param.empty() ? fixed_ns : 0;
  for (const auto& [value, ns] : ns_by_value) longest = std::max(longest, ns);
  return longest;
}

Acquisition read_acquisition(const Json& value) {
  Acquisition acquisition;
  const auto model = value.at("model").get<std::string>();
  acquisition.model = model == "streamed" ? Acquisition::Model::streamed : Acquisition::Model::polled;
  acquisition.latency_ns = value.value("latency_ns", std::int64_t{0});
  acquisition.interval_ns = optional_member<std::int64_t>(value, "interval_ns");
  acquisition.periods = optional_member<std::int64_t>(value, "periods");
  acquisition.published_every = value.value("published_every", std::int64_t{1});
  if (const auto conversion = value.find("conversion"); conversion != value.end())
    acquisition.conversion = read_conversion(*conversion);
  return acquisition;
}

}  // namespace finemote::gen
