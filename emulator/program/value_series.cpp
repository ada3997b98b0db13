#include "emulator/program/value_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kLeast = 1'000'000;                          // ns between looks
constexpr std::size_t kMostLooks = 250, kFewLooks = 25;             // of one quantity
constexpr std::size_t kMostValues = 50'000, kMostQuantities = 800;  // of all together

std::int64_t looks_for(std::size_t quantities) {
  const std::size_t share = kMostValues / std::max<std::size_t>(quantities, 1);
  return static_cast<std::int64_t>(std::clamp(share, kFewLooks, kMostLooks));
}

Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{:.6g}", value)) + 0.0;  // no -0
}

}  // namespace

ValueSeries::ValueSeries(Board& board, Outfit& outfit, std::int64_t from_ns, std::int64_t to_ns)
    : board_(board), outfit_(outfit), from_ns_(from_ns), every_ns_(kLeast) {
  for (const std::string& part : outfit.names()) {
    for (const PartValue& value : outfit.values(part)) {
      if (!value.is_of_family && series_.size() < kMostQuantities) series_.push_back({part, value.name, value.unit});
    }
  }
  const std::int64_t steps = looks_for(series_.size()) - 1;
  every_ns_ = std::max(kLeast, (to_ns - from_ns + steps - 1) / steps);
  needed_ = series_.empty() || to_ns < from_ns ? 0 : static_cast<std::size_t>((to_ns - from_ns) / every_ns_ + 1);
  plan();
}

void ValueSeries::plan() {
  if (looks_ == needed_) return;
  const std::int64_t at = from_ns_ + static_cast<std::int64_t>(looks_) * every_ns_;
  board_.world().at(from_ns(static_cast<std::uint64_t>(at)), [this] { look(); });
}

void ValueSeries::look() {
  for (Series& series : series_) series.seen.push_back(outfit_.value(series.part, series.value));
  ++looks_;
  plan();
}

Json ValueSeries::document(std::int64_t zero_ns) const {
  Json all = Json::array();
  for (const Series& series : series_) {
    Json values = Json::array();
    for (const double value : series.seen) values.push_back(rounded(value));
    all.push_back({{"part", series.part},
                   {"value", series.value},
                   {"unit", series.unit},
                   {"from_ns", from_ns_ - zero_ns},
                   {"every_ns", every_ns_},
                   {"values", std::move(values)}});
  }
  return all;
}

}  // namespace finemote::emulator
