#include "generator/schedule/period.hpp"

#include <string_view>
#include <utility>

namespace finemote::gen {
namespace {

std::pair<std::int64_t, std::string_view> split(std::int64_t period_ns) {
  constexpr std::pair<std::int64_t, std::string_view> kUnits[] = {
      {1'000'000'000, "s"}, {1'000'000, "ms"}, {1'000, "us"}};
  for (const auto& [size, unit] : kUnits) {
    if (period_ns % size == 0) return {period_ns / size, unit};
  }
  return {period_ns, "ns"};
}

}  // namespace

std::string period_label(std::int64_t period_ns) {
  const auto [count, unit] = split(period_ns);
  return std::to_string(count) + std::string(unit);
}

std::string period_text(std::int64_t period_ns) {
  const auto [count, unit] = split(period_ns);
  return std::to_string(count) + " " + std::string(unit);
}

}  // namespace finemote::gen
