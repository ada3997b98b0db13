// Times of a series to its extremes, its mean and its spread.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// Smallest, mean, standard deviation and largest of a series, ns. With count 0 the rest means nothing.
struct Statistics {
  std::uint64_t count = 0;
  Duration min, max;
  double mean_ns = 0, sd_ns = 0;  ///< fractions of a nanosecond count; sd: of the whole series (divides by count)
};

Statistics summarize(const std::vector<Duration>& values);

/// Of two series as one.
Statistics together(const Statistics& a, const Statistics& b);

}  // namespace finemote::gen
