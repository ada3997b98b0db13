#include "generator/timing/job_streams.hpp"

#include <algorithm>
#include <tuple>

#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {
namespace {

using Budget = Stream::Budget;

bool are_alike(const Budget& a, const Budget& b) {
  return a.period == b.period && a.carry_in == b.carry_in && a.every == 1 && b.every == 1 && a.jitter == b.jitter &&
         a.most == kUnlimited && b.most == kUnlimited;
}

/// Budgets that grow at the same instants are one: large robots have thousands.
void join_alike(std::vector<Budget>& budgets) {
  const auto key = [](const Budget& b) {
    return std::tuple<std::int64_t, std::int64_t, Duration, Duration, std::int64_t>(b.most, b.every, b.period, b.jitter,
                                                                                    b.carry_in);
  };
  std::stable_sort(budgets.begin(), budgets.end(), [&](const Budget& a, const Budget& b) { return key(a) < key(b); });
  std::vector<Budget> joined;
  for (const Budget& budget : budgets) {
    if (!joined.empty() && are_alike(joined.back(), budget)) {
      joined.back().count = add(joined.back().count, budget.count);
    } else {
      joined.push_back(budget);
    }
  }
  budgets = std::move(joined);
}

/// The streams in windows of the jobs of one bucket.
class JobWindows {
 public:
  /// Everything must outlive this.
  JobWindows(const TaskSet& set, const Responses& responses, std::size_t bucket)
      : set_(set), responses_(responses), bucket_(bucket) {}

  /// @param has_handles  of windows that end behind the updates of the job
  [[nodiscard]] std::vector<Stream> streams(bool has_handles) const {
    std::vector<Stream> all = set_.streams;
    for (Stream& stream : all) {
      for (Budget& budget : stream.budgets) narrow(stream, has_handles, budget);
      keep_one_masked_request(stream.budgets);
      join_alike(stream.budgets);
    }
    return all;
  }

 private:
  void narrow(const Stream& stream, bool has_handles, Budget& budget) const {
    switch (budget.cause) {
      case InterruptCause::clock:
        return;
      case InterruptCause::request:
        budget.carry_in = 0;
        if (is_own(budget)) budget.most = has_handles || budget.in_update ? budget.count : 0;
        return;
      case InterruptCause::transfer:
        if (const auto ended = set_.ended[*stream.place][set_.bucket_of[budget.device]])
          narrow_transfer(*ended, has_handles || budget.in_update, budget);
        return;
      case InterruptCause::look:
        budget.carry_in = 1;
        if (is_own(budget)) budget.most = multiply(2, budget.count);
        if (is_less_urgent(budget)) budget.most = budget.count;
        return;
    }
  }

  /// @param ended  all of them, so long after the release of the job that asked
  void narrow_transfer(Duration ended, bool asks_in_window, Budget& budget) const {
    if (is_less_urgent(budget)) {
      budget.most = budget.count;  // of the job before the window: it asks for no more while more urgent work waits
    } else if (!is_own(budget)) {
      budget.carry_in = 0;
      budget.jitter = ended;
    } else if (responses_.ok(bucket_) && ended + responses_.bucket[bucket_] <= budget.period) {
      // The window begins no longer before the release than more urgent work alone can last, which is less than the
      // response time: by then the transfers of the job before have ended.
      budget.most = asks_in_window ? budget.count : 0;
    }
  }

  /// At the begin of a window at most one less urgent stage is in a masked section, and has asked for one transfer. Or
  /// a less urgent job has put frames into their slots and not asked yet: the next request takes them along, for which
  /// this one stands.
  void keep_one_masked_request(std::vector<Budget>& budgets) const {
    const auto is_masked = [&](const Budget& b) { return b.cause == InterruptCause::request && is_less_urgent(b); };
    const auto first = std::find_if(budgets.begin(), budgets.end(), is_masked);
    if (first == budgets.end()) return;
    first->most = 1;
    budgets.erase(std::remove_if(first + 1, budgets.end(), is_masked), budgets.end());
  }

  [[nodiscard]] bool is_own(const Budget& budget) const { return set_.bucket_of[budget.device] == bucket_; }
  [[nodiscard]] bool is_less_urgent(const Budget& budget) const { return set_.bucket_of[budget.device] > bucket_; }

  const TaskSet& set_;
  const Responses& responses_;
  std::size_t bucket_;
};

}  // namespace

void separate_jobs(const Model& model, const Responses& responses, TaskSet& set, Effort& effort) {
  set.ended = TransferBounds(model, Profile::target, set, responses, effort).ended();
  std::vector<JobStreams> of_jobs;
  for (std::size_t w = 0; w < set.buckets.size(); ++w) {
    const JobWindows windows(set, responses, w);
    of_jobs.push_back({windows.streams(false), windows.streams(true)});
  }
  set.of_jobs = std::move(of_jobs);
}

}  // namespace finemote::gen::timing
