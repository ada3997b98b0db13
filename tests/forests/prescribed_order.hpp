// The order the paper prescribes for a forest, written down a second time and by other means than the generator's.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "forests/random_forest.hpp"

namespace finemote::test {

/// Period in ms -> stages of one job, `+name` for update and `-name` for handle.
std::map<int, std::vector<std::string>> prescribed_order(const RandomForest& forest);

}  // namespace finemote::test
