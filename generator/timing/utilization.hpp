// Utilisation and the two classic sufficient tests, decided without rounding.
#pragma once

#include "generator/timing/result.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

struct UtilizationTests {
  Utilization utilization;
  LiuLayland liu_layland;      ///< Liu and Layland, J. ACM 20(1), 1973; decided as (n+U)^n <= 2 n^n
  bool hyperbolic_ok = false;  ///< product of (1 + C/P) <= 2; Bini and Buttazzo, IEEE Trans. Computers 52(7), 2003
};

/// Over all buses (period min(frame, tick), as in the paper) and buckets; a bus of zero cost counts in n.
UtilizationTests test_utilization(const Model& model);

/// Whether the streams and the buckets before `bucket` alone need all the time there is: then no fixed point exists.
/// Decided exactly. Streams count by their separation, budgets where they are the smaller rate.
bool is_saturated(const TaskSet& set, std::size_t bucket);

/// Not below the least fixed point of x = base + work of the streams and of the buckets before `bucket` in [0, x), in
/// closed form: every ceil(x/T) counts as x/T + 1. kNever when they are saturated, or 64 bits do not hold it.
Duration closed_fixed_point(const TaskSet& set, std::size_t bucket, Duration base);

}  // namespace finemote::gen::timing
