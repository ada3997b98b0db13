// How much more urgent work can arrive in a window that opens at a given instant.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

inline constexpr Ns kNever = std::numeric_limits<Ns>::max();

/// Counts the steps an analysis takes, so that no model can make it run for hours. One step is one evaluation of one
/// term; the budget is some seconds of work.
class Effort {
 public:
  explicit Effort(std::int64_t steps = std::int64_t{1} << 31) : left_(steps) {}
  void spend(std::int64_t steps) {
    if ((left_ -= steps) < 0) throw TooLong("the response times need more steps than the analysis allows");
  }

 private:
  std::int64_t left_;
};

/// Work of all streams and of some more urgent buckets in a window [0, x), as a staircase walked from left to right:
/// between two steps a query costs one comparison, at a step one or two divisions per stream.
class Demand {
 public:
  /// One term: `cost` for each of the arrivals at first, first + period, ... below x.
  struct Term {
    Ns first = 0;
    Ns period = 1;
    Ns cost = 0;
    Ns most = kNever;  ///< no more arrivals than this
  };

  explicit Demand(Effort& effort) : effort_(&effort) {}

  void add_streams(const std::vector<Stream>& streams) { streams_ = &streams; }
  void add(const Term& term) { terms_.push_back(term); }
  void clear_terms() { terms_.clear(), rewind(); }

  /// Sets how many arrivals of a term there are at most.
  void allow(std::size_t term, Ns most) {
    if (terms_[term].most != most) terms_[term].most = most, rewind();
  }

  /// Lets the next query be smaller than the last one.
  void rewind() { begin_ = kNever, end_ = 0; }

  /// Work in [0, x) for x >= 1. Throws Overflow, TooLong.
  Ns at(Ns x) {
    if (x > end_ || x < begin_) evaluate(x);
    return value_;
  }

 private:
  void evaluate(Ns x) {
    begin_ = x;
    end_ = kNever;
    value_ = 0;
    if (streams_ != nullptr) {
      for (const Stream& s : *streams_) value_ = timing::add(value_, multiply(arrivals(s, x), s.cost));
    }
    for (const Term& t : terms_) {
      const Ns arrived = x > t.first ? ceil_div(x - t.first, t.period) : 0;
      limit(t.first, arrived, t.period);
      const Ns count = std::min(arrived, t.most);
      value_ = timing::add(value_, multiply(count, t.cost));
    }
    effort_->spend(static_cast<std::int64_t>(terms_.size()) + 4);
  }

  Ns arrivals(const Stream& s, Ns x) {
    const Ns by_separation = ceil_div(x, s.separation);
    limit(0, by_separation, s.separation);
    if (s.budgets.empty()) return by_separation;
    Ns by_budget = 0;
    for (const Stream::Budget& b : s.budgets) {
      const Ns periods = ceil_div(x, b.period);
      limit(0, periods, b.period);
      by_budget = timing::add(by_budget, multiply(b.count, timing::add(periods, b.carry_in)));
    }
    return std::min(by_separation, by_budget);
  }

  /// The staircase is flat up to and including first + count * period.
  void limit(Ns first, Ns count, Ns period) {
    Ns step = 0;
    if (__builtin_mul_overflow(count, period, &step) || __builtin_add_overflow(step, first, &step)) return;
    end_ = std::min(end_, step);
  }

  Effort* effort_;
  const std::vector<Stream>* streams_ = nullptr;
  std::vector<Term> terms_;
  Ns begin_ = kNever;  ///< value_ holds for x in [begin_, end_]
  Ns end_ = 0;
  Ns value_ = 0;
};

/// Least x >= start with base + demand(x) <= x, or kNever when it is above `limit`. Requires start >= 1.
inline Ns least_fit(Demand& demand, Ns base, Ns start, Ns limit) {
  for (Ns x = start;;) {
    if (x > limit) return kNever;
    const Ns need = add(base, demand.at(x));
    if (need <= x) return x;
    x = need;
  }
}

}  // namespace finemote::gen::timing
