#include "generator/schedule/period.hpp"

#include <string_view>
#include <utility>

namespace finemote::gen {
namespace {

std::pair<std::int64_t, std::string_view> split(Duration period) {
  constexpr std::pair<Duration, std::string_view> kUnits[] = {
      {seconds(1), "s"}, {milliseconds(1), "ms"}, {microseconds(1), "us"}};
  for (const auto& [size, unit] : kUnits) {
    if (is_multiple(period, size)) return {floor_div(period, size), unit};
  }
  return {period.ns(), "ns"};
}

}  // namespace

std::string period_label(Duration period) {
  const auto [count, unit] = split(period);
  return std::to_string(count) + std::string(unit);
}

std::string period_text(Duration period) {
  const auto [count, unit] = split(period);
  return std::to_string(count) + " " + std::string(unit);
}

}  // namespace finemote::gen
