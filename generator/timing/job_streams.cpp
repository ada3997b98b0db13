#include "generator/timing/job_streams.hpp"

#include <algorithm>
#include <tuple>

#include "generator/timing/demand.hpp"
#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {
namespace {

using Budget = Stream::Budget;

bool are_alike(const Budget& a, const Budget& b) {
  return a.period == b.period && a.carry_in == b.carry_in && a.every == 1 && b.every == 1 && a.jitter == b.jitter &&
         a.separation == b.separation && a.most == kUnlimited && b.most == kUnlimited;
}

/// Budgets that grow at the same instants are one: large robots have thousands.
void join_alike(std::vector<Budget>& budgets) {
  const auto key = [](const Budget& b) {
    return std::tuple(b.most, b.every, b.period, b.jitter, b.carry_in, b.separation);
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

/// Where in a job a window begins and ends.
enum class Window {
  updates,  ///< from before the release to an update() of the job
  whole,    ///< from before the release to anywhere in it
  inside,   ///< from the begin of one of its stages to anywhere in it
  rest,     ///< from behind its updates to anywhere in it
};

/// The streams in windows of the jobs of one bucket.
class JobWindows {
 public:
  /// Everything must outlive this.
  /// @param early  how long before a release higher-priority jobs can begin that last until then
  JobWindows(const TaskSet& set, std::size_t bucket, std::optional<Duration> early)
      : set_(set), bucket_(bucket), early_(early) {}

  [[nodiscard]] JobStreams all() const {
    return {streams(Window::updates), streams(Window::whole), streams(Window::inside), streams(Window::rest)};
  }

 private:
  [[nodiscard]] std::vector<Stream> streams(Window window) const {
    std::vector<Stream> all = set_.streams;
    for (Stream& stream : all) {
      for (Budget& budget : stream.budgets) narrow(stream, window, budget);
      keep_one_masked_request(window, stream.budgets);
      join_alike(stream.budgets);
    }
    return all;
  }

  static bool begins_in_job(Window window) { return window == Window::inside || window == Window::rest; }

  /// Whether those of the own bucket that are asked for in the window's part of the job run in it.
  static bool asks(Window window, const Budget& budget) {
    return budget.in_update ? window != Window::rest : window != Window::updates;
  }

  void narrow(const Stream& stream, Window window, Budget& budget) const {
    switch (budget.cause) {
      case InterruptCause::clock:
        return;
      case InterruptCause::request:
        budget.carry_in = 0;
        if (is_own(budget)) budget.most = asks(window, budget) ? budget.count : 0;
        return;
      case InterruptCause::transfer:
        if (const auto ended = set_.ended[*stream.place][set_.bucket_of[budget.device]])
          narrow_transfer(*ended, window, budget);
        return;
      case InterruptCause::look:
        budget.carry_in = 1;
        if (is_own(budget)) budget.most = multiply(window == Window::rest ? 1 : 2, budget.count);
        if (is_lower_priority(budget)) budget.most = budget.count;
        return;
    }
  }

  /// @param ended  all of them, so long after the release of the job that asked
  void narrow_transfer(Duration ended, Window window, Budget& budget) const {
    if (is_lower_priority(budget)) {
      budget.most = budget.count;  // of the job before the window: it asks for no more while higher-priority jobs wait
    } else if (!is_own(budget)) {
      budget.carry_in = 0;
      budget.jitter = ended;
    } else if (begins_in_job(window)) {
      budget.most = budget.count;  // by the release those of the job before have ended
    } else if (early_ && ended + *early_ <= budget.period) {
      budget.most = asks(window, budget) ? budget.count : 0;
    }
  }

  /// At the begin of a window at most one lower-priority stage is in a masked section, and has asked for one transfer:
  /// none where the job runs already. Or a lower-priority job has put frames into their slots and not asked yet: the
  /// next request takes them along, for which this one stands.
  void keep_one_masked_request(Window window, std::vector<Budget>& budgets) const {
    const auto is_masked = [&](const Budget& b) { return b.cause == InterruptCause::request && is_lower_priority(b); };
    const auto first = std::find_if(budgets.begin(), budgets.end(), is_masked);
    if (first == budgets.end()) return;
    const bool is_taken_along =
        std::any_of(budgets.begin(), budgets.end(), [&](const Budget& b) { return !is_masked(b) && b.most > 0; });
    first->most = is_taken_along || !begins_in_job(window) ? 1 : 0;
    budgets.erase(std::remove_if(first + 1, budgets.end(), is_masked), budgets.end());
  }

  [[nodiscard]] bool is_own(const Budget& budget) const { return set_.bucket_of[budget.device] == bucket_; }
  [[nodiscard]] bool is_lower_priority(const Budget& budget) const { return set_.bucket_of[budget.device] > bucket_; }

  const TaskSet& set_;
  std::size_t bucket_;
  std::optional<Duration> early_;
};

/// The longest time that interrupts and buckets of higher priority than one can keep the processor busy; none: not
/// known.
std::optional<Duration> busy_above(const TaskSet& set, std::size_t bucket, Effort& effort) {
  Demand demand(effort);
  demand.add_streams(set.streams);
  for (std::size_t v = 0; v < bucket; ++v) demand.add({{}, set.buckets[v].period, set.buckets[v].cost});
  const Duration busy = least_fit(demand, set.blocking, nanoseconds(1), set.buckets[bucket].period);
  return busy == kNever ? std::nullopt : std::optional<Duration>(busy);
}

/// Transfers that end within their period: all that one job causes lies in one, and no window holds more than it has
/// periods and one.
void note_ended(TaskSet& set) {
  for (Stream& stream : set.streams) {
    for (Budget& budget : stream.budgets) {
      if (!budget.may_last || !set.ended[*stream.place][set.bucket_of[budget.device]]) continue;
      budget.may_last = false;
      --budget.carry_in;
    }
  }
}

}  // namespace

void separate_jobs(const Model& model, const Responses& responses, TaskSet& set, Effort& effort) {
  set.ended = TransferBounds(model, Profile::target, set, responses, effort).ended();
  note_ended(set);
  std::vector<JobStreams> of_jobs;
  for (std::size_t w = 0; w < set.buckets.size(); ++w)
    of_jobs.push_back(JobWindows(set, w, busy_above(set, w, effort)).all());
  set.of_jobs = std::move(of_jobs);
}

}  // namespace finemote::gen::timing
