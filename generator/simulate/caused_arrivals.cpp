#include "generator/simulate/caused_arrivals.hpp"

#include <algorithm>

namespace finemote::gen {

using timing::AskedIn;
using timing::InterruptCause;
using Budget = timing::Stream::Budget;

CausedArrivals::CausedArrivals(const timing::Stream& stream, const timing::TaskSet& set, Random& random)
    : stream_(stream),
      set_(set),
      random_(random),
      jobs_left_(stream.budgets.size(), 0),
      at_end_(stream.budgets.size(), AtEnd::nothing) {}

bool CausedArrivals::asks(const Budget& budget, Rank device, bool is_update) {
  if (budget.device != device) return false;
  if (budget.cause == InterruptCause::look) return is_update;
  return budget.asked_in == (is_update ? AskedIn::update : AskedIn::handle);
}

bool CausedArrivals::cause(const timing::Stream& stream) {
  const auto is_caused = [](const Budget& budget) { return budget.cause != InterruptCause::clock; };
  return !stream.budgets.empty() && std::all_of(stream.budgets.begin(), stream.budgets.end(), is_caused);
}

Duration CausedArrivals::next() const { return planned_.empty() ? floor_div(Duration::max(), 4) : planned_.front(); }

void CausedArrivals::stage_began(Rank device, bool is_update, Duration release, Duration now) {
  for (std::size_t i = 0; i < stream_.budgets.size(); ++i) {
    const Budget& budget = stream_.budgets[i];
    if (!asks(budget, device, is_update)) continue;
    at_end_[i] = AtEnd::asks;
    if (random_.one_in(2)) continue;
    const bool has_asked = raise(i, release, now);
    at_end_[i] =
        has_asked && budget.cause == InterruptCause::request && budget.count > 1 ? AtEnd::asks_again : AtEnd::nothing;
  }
}

void CausedArrivals::stage_ended(Rank device, bool is_update, Duration release, Duration now) {
  for (std::size_t i = 0; i < stream_.budgets.size(); ++i) {
    if (!asks(stream_.budgets[i], device, is_update)) continue;
    if (at_end_[i] == AtEnd::asks) raise(i, release, now);
    if (at_end_[i] == AtEnd::asks_again) ask(stream_.budgets[i], now, now);
  }
}

void CausedArrivals::flush_began(std::size_t bucket, Duration release, Duration now) {
  for (std::size_t i = 0; i < stream_.budgets.size(); ++i) {
    const Budget& budget = stream_.budgets[i];
    if (budget.cause != InterruptCause::look && budget.asked_in == AskedIn::flush &&
        set_.bucket_of[budget.device] == bucket)
      raise(i, release, now);
  }
}

bool CausedArrivals::raise(std::size_t index, Duration release, Duration now) {
  const Budget& budget = stream_.budgets[index];
  if (budget.cause != InterruptCause::look && --jobs_left_[index] >= 0) return false;
  jobs_left_[index] = budget.every - 1;
  if (budget.cause == InterruptCause::look) planned_.clear();  // what the line did not use is lost
  const Duration latest = latest_end(budget, release, now);
  ask(budget, begin_of(budget, now, latest), latest);
  return true;
}

/// At once, as late as all of them fit, or between.
Duration CausedArrivals::begin_of(const Budget& budget, Duration now, Duration latest) {
  const Duration last = std::max(now, latest - (budget.count - 1) * stream_.separation);
  switch (random_.between(0, 2)) {
    case 0:
      return now;
    case 1:
      return last;
    default:
      return random_.between(now, last);
  }
}

/// Plans the interrupts of one budget as soon as the line allows; those that would come too late do not: of requests
/// there is one at an instant, for the routine of one runs before its stage asks for the next.
void CausedArrivals::ask(const Budget& budget, Duration from, Duration latest) {
  Duration at = std::max(from, free_from_);
  for (std::int64_t n = 0; n < budget.count && at <= latest; ++n) {
    planned_.push_back(at);
    at += stream_.separation;
    free_from_ = at;
  }
}

Duration CausedArrivals::latest_end(const Budget& budget, Duration release, Duration now) const {
  if (budget.cause == InterruptCause::request) return now;
  if (budget.cause == InterruptCause::look) return release + 2 * budget.period;
  return release + set_.ended[*stream_.place][set_.bucket_of[budget.device]].value_or(budget.period);
}

}  // namespace finemote::gen
