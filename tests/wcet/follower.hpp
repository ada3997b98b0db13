// Holds what ran against the ways that the static analysis allows, block by block.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "wcet/recording.hpp"
#include "wcet/routes.hpp"

namespace finemote::test {

/// What ran of one routine or of one bracket in it.
struct Followed {
  std::uint64_t runs = 0;
  std::uint64_t undisturbed = 0;       ///< of them: nothing came in between
  gen::wcet::Cycles longest_path = 0;  ///< by static costs
  double longest_run = 0;              ///< emulated cycles, without what came in between
  double closest = 0;                  ///< emulated by static cycles of the same run: at most 1
};

struct Findings {
  /// What contradicts the analysis: an edge that is not in the graph, time that the costs along the way do not cover, a
  /// way that is longer than the bound. At most ten of them in words.
  std::vector<std::string> mistakes;
  std::uint64_t count = 0;

  std::map<unsigned, Followed> routines;       ///< by exception
  std::map<std::uint32_t, Followed> brackets;  ///< by the begin mark
  std::set<std::uint32_t> bounds_passed;       ///< loop_bound marks
  std::map<std::uint32_t, std::uint64_t>
      faults;                 ///< by only_after_fault mark: how often it was passed after the bring-up
  std::uint64_t retries = 0;  ///< iterations that an interrupt has added
  std::set<std::pair<unsigned, std::size_t>> nodes;  ///< of the graphs that were passed: by exception

  void complain(const std::string& what) {
    if (++count <= 10) mistakes.push_back(what);
  }
};

Findings follow(const Recording& recording, const Routes& routes);

}  // namespace finemote::test
