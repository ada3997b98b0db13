// Runs of interrupt routines in the raw record of a run: when each began, and how long it took by itself.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace finemote::test {

/// All runs of one exception, in the order of their ends. Times in nanoseconds.
struct Routine {
  nlohmann::json meaning;  ///< as in the first line of the record: `kind`, `bus`, `source`, `period_ns`
  std::vector<double> begins;
  std::vector<double> own;     ///< stacking and unstacking included, other routines not
  std::vector<double> around;  ///< the same without the stages it ran
};

/// By the number of the exception. Of a record of one run, made on a board whose clock is exact.
std::map<int, Routine> routines_of(const std::string& audit);

double longest(const std::vector<double>& times);

}  // namespace finemote::test
