#include "generator/run/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::gen {

Statistics summarize(const std::vector<Duration>& values) {
  Statistics s;
  s.count = values.size();
  if (values.empty()) return s;
  s.min = *std::min_element(values.begin(), values.end());
  s.max = *std::max_element(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double sum = 0;  // of whole numbers, which a double holds as they are up to 2^53
  for (const Duration value : values) sum += static_cast<double>(value.ns());
  s.mean_ns = sum / count;
  double variance = 0;
  for (const Duration value : values) variance += std::pow(static_cast<double>(value.ns()) - s.mean_ns, 2) / count;
  s.sd_ns = std::sqrt(variance);
  return s;
}

Statistics together(const Statistics& a, const Statistics& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  Statistics s;
  s.count = a.count + b.count;
  s.min = std::min(a.min, b.min);
  s.max = std::max(a.max, b.max);
  const double share = static_cast<double>(b.count) / static_cast<double>(s.count);
  s.mean_ns = std::clamp(a.mean_ns + (b.mean_ns - a.mean_ns) * share, std::min(a.mean_ns, b.mean_ns),
                         std::max(a.mean_ns, b.mean_ns));
  const double between = (b.mean_ns - a.mean_ns) * (b.mean_ns - a.mean_ns) * share * (1 - share);
  s.sd_ns = std::sqrt(a.sd_ns * a.sd_ns * (1 - share) + b.sd_ns * b.sd_ns * share + between);
  return s;
}

}  // namespace finemote::gen
