#include "generator/timing/lags.hpp"

#include "generator/units/divider.hpp"

namespace finemote::gen::timing {
namespace {

template <typename InRow>
Lags lags(const TaskSet& set, const ReleaseTable& table, Rank producer, Duration consumer_period,
          ReleaseTable::Range range, Duration later, Effort& effort, InRow in_row) {
  const Duration step = gcd(set.buckets[set.bucket_of[producer]].period, consumer_period);
  Lags result;
  result.most = round_up(range.most + later, step);
  if (round_up(range.least + later, step) == result.most) return result;
  const std::size_t rows = table.rows(producer);
  if (!effort.spend(static_cast<std::int64_t>(rows))) return result;
  result.per_row.reserve(rows);
  const Divider by_step(step.ns());
  for (std::size_t row = 0; row < rows; ++row) {
    result.per_row.push_back(-by_step.floor(-(in_row(row) + later).ns()) * step);
  }
  return result;
}

}  // namespace

Lags lags_down(const TaskSet& set, const ReleaseTable& table, Rank producer, Duration consumer_period, Effort& effort) {
  return lags(set, table, producer, consumer_period, table.r_minus_range(producer),
              set.lag_of_handle(producer, consumer_period), effort,
              [&](std::size_t row) { return table.r_minus_in_row(producer, row); });
}

Lags lags_up(const TaskSet& set, const ReleaseTable& table, Rank producer, Duration consumer_period, Effort& effort) {
  return lags(set, table, producer, consumer_period, table.r_plus_range(producer),
              set.lag_of_update(producer, consumer_period), effort,
              [&](std::size_t row) { return table.r_plus_in_row(producer, row); });
}

}  // namespace finemote::gen::timing
