// Higher-priority demand: the execution time that can be requested in a window of length x.
#pragma once

#include <algorithm>
#include <vector>

#include "generator/timing/effort.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

inline constexpr Duration kNever = Duration::max();

/// The longest search for what ends at some time.
inline constexpr Duration kLongest = kNever - nanoseconds(1);

/// Execution time that all streams and some higher-priority buckets request in [0, x). A step function: queries should
/// have rising x. Between two steps a query costs one comparison, at a step a division for every stream or term that
/// steps there.
class Demand {
 public:
  /// One term: `cost` for each of the arrivals at first, first + period, ... below x.
  struct Term {
    Duration first;
    Duration period = nanoseconds(1);
    Duration cost;
    std::int64_t most = kUnlimited;  ///< no more arrivals than this
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
  /// Lets every term begin elsewhere, one after the other.
  void begin_at(const Duration* firsts) {
    for (Term& term : terms_) term.first = *firsts++;
    rewind();
  }

  /// Sets how many arrivals of a term there are at most.
  void allow(std::size_t term, std::int64_t most) {
    if (terms_[term].most == most) return;
    terms_[term].most = most;
    term_steps_[term] = {};
    begin_ = kNever, end_ = {};
  }

  /// Which stages of the job run in the window: all of them, if nobody says so.
  void run(const Stages& stages) {
    const auto differs = [&](const Raised& raised) { return raised.in(stages) != raised.in(stages_); };
    for (std::size_t i = 0; i < stream_steps_.size(); ++i) {
      const std::vector<Raised>& raised = (*streams_)[i].raised;
      if (std::none_of(raised.begin(), raised.end(), differs)) continue;
      stream_steps_[i] = {};
      begin_ = kNever, end_ = {};
    }
    stages_ = stages;
  }

  /// Lets the next query be smaller than the last one.
  void rewind() {
    begin_ = kNever, end_ = {};
    std::fill(stream_steps_.begin(), stream_steps_.end(), Step{});
    std::fill(term_steps_.begin(), term_steps_.end(), Step{});
  }

  /// No steps are left: whoever searches gives up.
  [[nodiscard]] bool is_spent() const { return effort_->is_spent(); }

  /// Execution time that is requested in [0, x), x >= 1 ns. Throws Overflow.
  Duration at(Duration x) {
    if (x > end_ || x < begin_) evaluate(x);
    return value_;
  }

 private:
  /// The part of one stream or term: `value` up to and including `end`.
  struct Step {
    Duration end;
    Duration value;
  };

  void evaluate(Duration x) {
    if (x < begin_ && begin_ != kNever) rewind();
    begin_ = x;
    end_ = kNever;
    value_ = {};
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
    value_ += step.value;
    end_ = std::min(end_, step.end);
  }

  static Step step(const Term& t, Duration x) {
    const std::int64_t arrived = x > t.first ? ceil_div(x - t.first, t.period) : 0;
    return {arrived >= t.most ? kNever : flat_to(t.first, arrived, t.period), std::min(arrived, t.most) * t.cost};
  }

  [[nodiscard]] Step step(const Stream& s, Duration x) const {
    const std::int64_t by_separation = ceil_div(x, s.separation);
    const auto apart = [&] { return Step{flat_to({}, by_separation, s.separation), by_separation * s.cost}; };
    if (!s.has_budgets()) return apart();
    Duration end = kNever;
    std::int64_t by_budget = 0;
    const auto count_apart = [&](std::int64_t count, Duration separation, Duration count_end) {
      const std::int64_t apart = separation > Duration::zero() ? ceil_div(x, separation) : kUnlimited;
      end = std::min(end, apart < count ? flat_to({}, apart, separation) : count_end);
      by_budget = gen::add(by_budget, std::min(count, apart));
    };
    for (const Stream::Budget& b : s.budgets) {
      const std::int64_t periods = ceil_div(x + b.jitter, b.period);
      const std::int64_t count = multiply(b.count, ceil_div(gen::add(periods, b.carry_in), b.every));
      const Duration count_end = count < b.most ? flat_to(-b.jitter, periods, b.period) : kNever;
      count_apart(std::min(count, b.most), b.separation, count_end);
    }
    for (const Raised& raised : s.raised) count_apart(raised.in(stages_), raised.separation(), kNever);
    // None of the two gets smaller, so the step of the smaller one holds. The other may be too large to be a time.
    return by_budget <= by_separation ? Step{end, by_budget * s.cost} : apart();
  }

  /// The staircase is flat up to and including first + count * period.
  static Duration flat_to(Duration first, std::int64_t count, Duration period) {
    std::int64_t end = 0;
    const bool is_beyond =
        __builtin_mul_overflow(count, period.ns(), &end) || __builtin_add_overflow(end, first.ns(), &end);
    return is_beyond ? kNever : nanoseconds(end);
  }

  Effort* effort_;
  const std::vector<Stream>* streams_ = nullptr;
  Stages stages_;
  std::vector<Term> terms_;
  std::vector<Step> stream_steps_, term_steps_;
  Duration begin_ = kNever;  ///< value_ holds for x in [begin_, end_]
  Duration end_;
  Duration value_;
};

/// Least x >= start with base + demand(x) <= x, or kNever when it is above `limit` or the steps are spent. Requires
/// start >= 1 ns.
inline Duration least_fit(Demand& demand, Duration base, Duration start, Duration limit) {
  for (Duration x = start;;) {
    if (x > limit || demand.is_spent()) return kNever;
    const Duration need = base + demand.at(x);
    if (need <= x) return x;
    x = need;
  }
}

}  // namespace finemote::gen::timing
