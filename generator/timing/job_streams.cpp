#include "generator/timing/job_streams.hpp"

#include <algorithm>
#include <tuple>

#include "generator/timing/demand.hpp"
#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {
namespace {

using Budget = Stream::Budget;

/// Gathers what the stages of a job raise, in any order.
class Gathered {
 public:
  void add(const Raised::Kind& kind, std::size_t place, std::int64_t count) { stages_.push_back({kind, place, count}); }
  /// Whichever of these stages runs raises one more, and not one each.
  void add_one_of_any() {
    const std::size_t size = stages_.size();
    const Raised::Kind one{0, {}, false, 1};
    for (std::size_t i = 0; i < size; ++i) stages_.push_back({one, stages_[i].place, 1});
  }

  [[nodiscard]] std::vector<Raised> sums() && {
    std::sort(stages_.begin(), stages_.end(),
              [](const Stage& a, const Stage& b) { return std::tie(a.kind, a.place) < std::tie(b.kind, b.place); });
    std::vector<Raised> sums;
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      const auto& [kind, place, count] = stages_[i];
      if (i == 0 || kind != stages_[i - 1].kind) sums.emplace_back(kind);
      sums.back().add(place, count);
    }
    return sums;
  }

 private:
  struct Stage {
    Raised::Kind kind;
    std::size_t place;
    std::int64_t count;
  };
  std::vector<Stage> stages_;
};

/// Where a window begins.
enum class Begin { before_job, in_job };

/// The streams in windows of the jobs of one bucket.
class JobWindows {
 public:
  /// Everything must outlive this.
  /// @param early  how long before a release higher-priority jobs can begin that last until then
  JobWindows(const TaskSet& set, std::size_t bucket, std::optional<Duration> early)
      : set_(set), bucket_(bucket), early_(early) {}

  [[nodiscard]] JobStreams all() const { return {streams(Begin::before_job), streams(Begin::in_job)}; }

 private:
  [[nodiscard]] std::vector<Stream> streams(Begin begin) const {
    std::vector<Stream> all = set_.streams;
    for (Stream& stream : all) {
      Gathered own = gather(stream, begin);
      for (Budget& budget : stream.budgets) narrow(stream, budget);
      keep_one_masked_request(begin, stream.budgets, own);
      stream.raised = std::move(own).sums();
      join_alike(stream.budgets);
    }
    return all;
  }

  /// Takes what the job itself raises out of the budgets of the stream, but for what counts as in any window.
  Gathered gather(Stream& stream, Begin begin) const {
    Gathered own;
    const auto left = std::stable_partition(stream.budgets.begin(), stream.budgets.end(),
                                            [&](const Budget& b) { return is_own(b) && is_raised(stream, begin, b); });
    for (auto budget = stream.budgets.begin(); budget != left; ++budget) raise(*budget, own);
    stream.budgets.erase(stream.budgets.begin(), left);
    return own;
  }

  /// Whether windows hold no more than what the stages of one job of their own raise.
  [[nodiscard]] bool is_raised(const Stream& stream, Begin begin, const Budget& budget) const {
    if (budget.cause == InterruptCause::clock) return false;
    if (budget.cause != InterruptCause::transfer) return true;
    // Those of the job before have ended by the release, and where the window begins.
    const auto ended = set_.ended[*stream.place][bucket_];
    if (begin == Begin::in_job || !ended) return ended.has_value();
    return early_ && *ended + *early_ <= set_.buckets[bucket_].period;
  }

  void raise(const Budget& budget, Gathered& own) const {
    const Raised::Kind stage{budget.kind, budget.separation}, and_behind{budget.kind, budget.separation, true};
    if (budget.cause == InterruptCause::look) {
      own.add(and_behind, 0, budget.count);  // left from the look before
      own.add(stage, set_.update_place(budget.device), budget.count);
    } else {
      own.add(budget.cause == InterruptCause::transfer ? and_behind : stage, asked_at(budget), budget.count);
    }
  }

  /// The stage of the own job that asks.
  [[nodiscard]] std::size_t asked_at(const Budget& budget) const {
    if (budget.asked_in == AskedIn::flush) return set_.flush_place(bucket_);
    const bool is_update = budget.asked_in == AskedIn::update;
    return is_update ? set_.update_place(budget.device) : set_.handle_place(budget.device);
  }

  /// What jobs of other buckets raise.
  void narrow(const Stream& stream, Budget& budget) const {
    if (is_own(budget)) return;
    switch (budget.cause) {
      case InterruptCause::clock:
        return;
      case InterruptCause::request:
        budget.carry_in = 0;
        return;
      case InterruptCause::transfer:
        if (const auto ended = set_.ended[*stream.place][set_.bucket_of[budget.device]])
          narrow_transfer(*ended, budget);
        return;
      case InterruptCause::look:
        budget.carry_in = 1;
        if (is_lower_priority(budget)) budget.most = budget.count;
        return;
    }
  }

  /// @param ended  by when all of them have, after the release of the job that asked
  void narrow_transfer(Duration ended, Budget& budget) const {
    if (is_lower_priority(budget)) {
      budget.most = budget.count;  // of the job before the window: it asks for no more while higher-priority jobs wait
    } else {
      budget.carry_in = 0;
      budget.jitter = ended;
    }
  }

  /// Of the budgets from `first` on, which are requests of lower-priority jobs, one request is left: in any window, or
  /// with that of any own stage.
  static void leave_one(Begin begin, std::vector<Budget>& budgets, std::vector<Budget>::iterator first, Gathered& own) {
    const bool others_ask = std::any_of(budgets.begin(), first, [](const Budget& b) { return b.count > 0; });
    const bool is_in_any = begin == Begin::before_job || others_ask;
    if (!is_in_any) own.add_one_of_any();
    first->most = is_in_any ? 1 : 0;
    budgets.erase(first + 1, budgets.end());
  }

  /// When a window begins, at most one lower-priority stage is in a masked section, and has asked for one transfer:
  /// none where the job runs already. Or a lower-priority job has put frames into their slots and not asked yet: the
  /// next request takes them along, for which this one stands.
  void keep_one_masked_request(Begin begin, std::vector<Budget>& budgets, Gathered& own) const {
    const auto masked = std::stable_partition(budgets.begin(), budgets.end(), [&](const Budget& b) {
      return b.cause != InterruptCause::request || !is_lower_priority(b) || b.count == 0;
    });
    if (masked != budgets.end()) leave_one(begin, budgets, masked, own);
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
void note_ended(const TaskSet& set, std::vector<Stream>& streams) {
  for (Stream& stream : streams) {
    for (Stream::Budget& budget : stream.budgets) {
      if (budget.lasting == 0 || !set.ended[*stream.place][set.bucket_of[budget.device]]) continue;
      budget.carry_in -= budget.lasting;
      budget.lasting = 0;
    }
  }
}

}  // namespace

void separate_jobs(const Model& model, const Responses& responses, TaskSet& set, Effort& effort) {
  set.ended = TransferBounds(model, Profile::target, set, responses, effort).ended();
  for (std::vector<Stream>* streams : {&set.streams, &set.sources, &set.dma}) note_ended(set, *streams);
  std::vector<JobStreams> of_jobs;
  for (std::size_t w = 0; w < set.buckets.size(); ++w)
    of_jobs.push_back(JobWindows(set, w, busy_above(set, w, effort)).all());
  set.of_jobs = std::move(of_jobs);
}

}  // namespace finemote::gen::timing
