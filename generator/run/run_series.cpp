#include "generator/run/run_series.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostAges = 200, kFewAges = 20;  // of one chain
constexpr std::size_t kAllAges = 20'000;               // of all together

Json maybe(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

Json value_list(const std::vector<ValueSeries>& all) {
  Json list = Json::array();
  for (const ValueSeries& series : all) {
    std::optional<double> lowest, highest, last;
    Json values = Json::array();
    for (const std::optional<double>& value : series.values) {
      values.push_back(maybe(value));
      if (!value) continue;
      lowest = lowest ? std::min(*lowest, *value) : *value;
      highest = highest ? std::max(*highest, *value) : *value;
      last = value;
    }
    list.push_back({{"part", series.part},
                    {"value", series.value},
                    {"unit", series.unit},
                    {"from_ns", series.from.ns()},
                    {"every_ns", series.every.ns()},
                    {"lowest", maybe(lowest)},
                    {"highest", maybe(highest)},
                    {"last", maybe(last)},
                    {"values", std::move(values)}});
  }
  return list;
}

Json ages_of(const MeasuredChain& chain, std::size_t most) {
  Json times = Json::array(), ages = Json::array();
  const std::size_t count = chain.ages.size(), windows = std::min(count, most);
  for (std::size_t i = 0; i < windows; ++i) {
    const auto begin = chain.ages.begin() + static_cast<std::ptrdiff_t>(i * count / windows);
    const auto end = chain.ages.begin() + static_cast<std::ptrdiff_t>((i + 1) * count / windows);
    const auto oldest =
        std::max_element(begin, end, [](const MeasuredAge& a, const MeasuredAge& b) { return a.age < b.age; });
    times.push_back(oldest->at.ns());
    ages.push_back(oldest->age.ns());
  }
  return {{"t_ns", std::move(times)}, {"age_ns", std::move(ages)}};
}

std::size_t most_ages(std::size_t chains) {
  return std::clamp(kAllAges / std::max<std::size_t>(chains, 1), kFewAges, kMostAges);
}

}  // namespace finemote::gen
