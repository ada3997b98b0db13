// The bounds of expressions: generous for robots, and reached within a second by an input that never ends.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "generator/expression/failure.hpp"
#include "generator/expression/heap.hpp"

namespace finemote::gen::expression {

inline constexpr std::size_t kMaxSteps = 10'000'000;       ///< operations inside one expression
inline constexpr std::size_t kMaxTotalSteps = 50'000'000;  ///< operations of all expressions, and elements visited
inline constexpr std::size_t kMaxMemory = std::size_t{1} << 30;  ///< bytes in use at a time
inline constexpr std::size_t kMaxText = std::size_t{64} << 20;   ///< bytes of one text value
inline constexpr std::size_t kMaxItems = 4'000'000;              ///< items of one list, range or repetition
inline constexpr std::size_t kMaxExpressionDepth = 200;          ///< brackets inside brackets of one expression
inline constexpr std::size_t kMaxEvalDepth = 10'000;             ///< expressions inside expressions, through properties

/// Counts the work of one expression.
class Budget {
 public:
  void begin_expression() { total_ += std::exchange(steps_, 0); }
  void spend(std::size_t steps) {
    steps_ += steps;
    if (steps_ > kMaxSteps) fail_limit("the expression needs too many operations");
    if (total_ > kMaxTotalSteps) fail_limit("the expressions of the file need too many operations");
    look_at_memory(steps);
  }
  /// Work outside of expressions.
  void visit(std::size_t steps) {
    total_ += steps;
    if (total_ > kMaxTotalSteps) fail_limit("the expansion needs too many operations");
    look_at_memory(steps);
  }

 private:
  /// Seldom enough to cost nothing, and often enough for what the steps in between can take up.
  void look_at_memory(std::size_t steps) {
    constexpr std::size_t interval = 1 << 18;
    unlooked_ += steps;
    if (unlooked_ < interval) return;
    unlooked_ = 0;
    if (heap_in_use() > kMaxMemory) {
      fail_limit(fmt::format("the expansion needs more than {} GiB of memory", kMaxMemory >> 30));
    }
  }

  std::size_t steps_ = 0;
  std::size_t total_ = 0;
  std::size_t unlooked_ = 0;
};

/// One level of recursion, as long as it lives.
class Level {
 public:
  Level(std::size_t& depth, std::size_t limit, const char* message) : depth_(depth) {
    if (depth_ >= limit) fail_limit(message);
    ++depth_;
  }
  ~Level() { --depth_; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  std::size_t& depth_;
};

}  // namespace finemote::gen::expression
