// Timing results to the tables people read.
#pragma once

#include <string>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// `104.5 us`: three decimals at most, rounded up, so that a printed bound is never below the computed one.
std::string duration_text(Ns ns);
std::string duration_text(std::optional<Ns> ns);  ///< `-` for none

/// Rows with columns as wide as their widest cell: the first one to the left, all others to the right.
class Table {
 public:
  explicit Table(std::vector<std::string> head) { row(std::move(head)); }
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Of the asked profile: the verdict on one line, buckets, who uses the processor, devices, trees, chains, buses and
/// requirements; last the figures that decide nothing.
std::string timing_table(const Timing& timing);

}  // namespace finemote::gen::timing
