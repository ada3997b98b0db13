// How much more urgent work can arrive in a window that opens at a given instant.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

inline constexpr Ns kNever = std::numeric_limits<Ns>::max();

/// Some seconds of work.
inline constexpr std::int64_t kMostSteps = std::int64_t{1} << 31;

/// Counts the steps an analysis takes, so that no model can make it run for hours. One step is one evaluation of one
/// term.
class Effort {
 public:
  explicit Effort(std::int64_t steps = kMostSteps) : left_(steps) {}
  void spend(std::int64_t steps) {
    if ((left_ -= steps) < 0) throw TooLong("the response times need more steps than the analysis allows");
  }

 private:
  std::int64_t left_;
};

/// Work of all streams and of some more urgent buckets in a window [0, x), as a staircase walked from left to right:
/// between two steps a query costs one comparison, at a step a division for every stream or term that steps there.
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

  void add_streams(const std::vector<Stream>& streams) {
    streams_ = &streams;
    stream_steps_.resize(streams.size());
    rewind();
  }
  void add(const Term& term) {
    terms_.push_back(term);
    term_steps_.emplace_back();
    rewind();
  }
  void clear_terms() { terms_.clear(), term_steps_.clear(), rewind(); }

  /// Sets how many arrivals of a term there are at most.
  void allow(std::size_t term, Ns most) {
    if (terms_[term].most == most) return;
    terms_[term].most = most;
    term_steps_[term] = {};
    begin_ = kNever, end_ = 0;
  }

  /// Lets the next query be smaller than the last one.
  void rewind() {
    begin_ = kNever, end_ = 0;
    std::fill(stream_steps_.begin(), stream_steps_.end(), Step{});
    std::fill(term_steps_.begin(), term_steps_.end(), Step{});
  }

  /// Work in [0, x) for x >= 1. Throws Overflow, TooLong.
  Ns at(Ns x) {
    if (x > end_ || x < begin_) evaluate(x);
    return value_;
  }

 private:
  /// The part of one stream or term: `value` up to and including `end`.
  struct Step {
    Ns end = 0;
    Ns value = 0;
  };

  void evaluate(Ns x) {
    if (x < begin_ && begin_ != kNever) rewind();
    begin_ = x;
    end_ = kNever;
    value_ = 0;
    for (std::size_t i = 0; i < stream_steps_.size(); ++i) {
      if (x > stream_steps_[i].end) stream_steps_[i] = step((*streams_)[i], x);
      take(stream_steps_[i]);
    }
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (x > term_steps_[i].end) term_steps_[i] = step(terms_[i], x);
      take(term_steps_[i]);
    }
    effort_->spend(static_cast<std::int64_t>(terms_.size()) + 4);
  }

  void take(const Step& step) {
    value_ = gen::add(value_, step.value);
    end_ = std::min(end_, step.end);
  }

  static Step step(const Term& t, Ns x) {
    const Ns arrived = x > t.first ? ceil_div(x - t.first, t.period) : 0;
    return {arrived >= t.most ? kNever : flat_to(t.first, arrived, t.period),
            multiply(std::min(arrived, t.most), t.cost)};
  }

  static Step step(const Stream& s, Ns x) {
    const Ns by_separation = ceil_div(x, s.separation);
    Step step{flat_to(0, by_separation, s.separation), 0};
    Ns arrived = by_separation;
    if (!s.budgets.empty()) {
      Ns by_budget = 0;
      for (const Stream::Budget& b : s.budgets) {
        const Ns periods = ceil_div(x, b.period);
        step.end = std::min(step.end, flat_to(0, periods, b.period));
        by_budget = gen::add(by_budget, multiply(b.count, ceil_div(gen::add(periods, b.carry_in), b.every)));
      }
      arrived = std::min(arrived, by_budget);
    }
    step.value = multiply(arrived, s.cost);
    return step;
  }

  /// The staircase is flat up to and including first + count * period.
  static Ns flat_to(Ns first, Ns count, Ns period) {
    Ns end = 0;
    if (__builtin_mul_overflow(count, period, &end) || __builtin_add_overflow(end, first, &end)) return kNever;
    return end;
  }

  Effort* effort_;
  const std::vector<Stream>* streams_ = nullptr;
  std::vector<Term> terms_;
  std::vector<Step> stream_steps_, term_steps_;
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
