#include "generator/simulate/simulate.hpp"

#include <algorithm>
#include <deque>

#include "generator/simulate/arrivals.hpp"
#include "generator/simulate/data_flow.hpp"
#include "generator/simulate/jobs.hpp"
#include "generator/simulate/lengths.hpp"
#include "generator/simulate/wires.hpp"
#include "generator/timing/profile.hpp"

namespace finemote::gen {
namespace {

/// A piece of interrupt work; the release interrupt makes its buckets ready at its end.
struct Interrupt {
  std::size_t stream = 0;
  Duration left;
  Duration begin = kNothing;
  std::vector<std::size_t> due;  ///< buckets, for a release
  Duration released;
};

/// Tells an observer, if there is one, which values a stage uses as it begins.
class InputReporter {
 public:
  InputReporter(const timing::Model& model, const timing::Topology& topology, const DataFlow& flow,
                SimulationObserver* observer)
      : model_(model), topology_(topology), flow_(flow), observer_(observer) {}

  void inputs(Rank device, bool is_update, Duration now) const {
    using Stage = SimulationObserver::Stage;
    if (observer_ == nullptr) return;
    const auto report = [&](Rank producer, Duration published, Stage stage) {
      if (published >= Duration::zero()) observer_->hand_over(producer, device, stage, published, now);
    };
    if (!is_update) {
      if (const auto parent = model_.devices[device].parent)
        report(*parent, flow_.command_time(*parent), Stage::handle);
      return;
    }
    for (const Rank child : topology_.children[device]) report(child, flow_.state_time(child), Stage::update);
    for (const Rank read : model_.devices[device].reads) report(read, flow_.state_time(read), Stage::update);
  }

 private:
  const timing::Model& model_;
  const timing::Topology& topology_;
  const DataFlow& flow_;
  SimulationObserver* observer_;
};

/// With what the analysis knows of when transfers have ended.
timing::TaskSet task_set_of(const timing::Model& model, timing::Profile profile) {
  if (profile != timing::Profile::target) return timing::make_task_set(model, profile);
  return timing::analyse_deadlines(model, profile).set;
}

/// Of a stage: nothing but profile `target` knows any.
Duration least_time(const timing::Device& device, bool is_update, timing::Profile profile) {
  if (profile != timing::Profile::target) return {};
  return is_update ? device.update_bcet : device.handle_bcet;
}

/// One processor: interrupts before jobs, jobs by the rank of their buckets.
class Simulator {
 public:
  Simulator(const timing::Model& model, const SimulationOptions& options, SimulationObserver* observer)
      : model_(model),
        options_(options),
        observer_(observer),
        topology_(timing::make_topology(model)),
        set_(task_set_of(model, options.profile)),
        random_(options.seed),
        lengths_(random_),
        clock_(set_.buckets),
        flow_(model, topology_, options.chains),
        reporter_(model, topology_, flow_, observer),
        wires_(set_.sources, model.buses.size()),
        jobs_(set_.buckets.size()),
        update_begin_(model.devices.size()) {
    for (const timing::TaskBucket& bucket : set_.buckets) pieces_.emplace_back(set_, bucket);
    result_.devices.resize(model.devices.size());
    for (const ChainEnds& ends : options.chains) result_.chains.push_back({ends, kNothing});
    for (const timing::Stream& source : set_.sources) arrivals_.emplace_back(source, set_, random_);
  }

  Simulation run() {
    while (now_ < options_.duration && ++steps_ < options_.most_steps && interrupts_.size() < options_.most_waiting) {
      const Duration event = next_event();
      if (event <= now_) {
        admit();
        continue;
      }
      if (!interrupts_.empty()) {
        run_interrupt(event);
      } else if (const std::size_t w = most_urgent(); w < jobs_.size()) {
        run_job(w, event);
      } else {
        now_ = event;
      }
    }
    for (const JobState& job : jobs_) result_.misses += job.active && job.next && *job.next < now_ ? 1 : 0;
    result_.duration = std::min(now_, options_.duration);
    return std::move(result_);
  }

 private:
  [[nodiscard]] Duration next_event() const {
    Duration event = clock_.next();
    for (const Arrivals& a : arrivals_) event = std::min(event, a.next());
    return std::max(event, masked_until_);
  }

  [[nodiscard]] std::size_t most_urgent() const {
    std::size_t w = 0;
    while (w < jobs_.size() && !jobs_[w].active) ++w;
    return w;
  }

  void admit() {
    masked_until_ = {};
    for (std::size_t s = 0; s < arrivals_.size(); ++s) {
      while (arrivals_[s].next() <= now_ && interrupts_.size() < options_.most_waiting) {
        if (wires_.carries(set_.sources[s], arrivals_[s].next()))
          interrupts_.push_back({s, lengths_.draw({}, set_.sources[s].cost), kNothing, {}, {}});
        const auto w = static_cast<std::size_t>(random_.between(0, static_cast<std::int64_t>(jobs_.size()) - 1));
        arrivals_[s].advance(clock_.next_of(w));
      }
    }
    ReleaseClock::Due due = clock_.take(now_);
    if (!due.buckets.empty()) release(std::move(due));
    if (set_.least_lag == Duration::zero() && interrupts_.empty()) run_without_time();
  }

  void run_without_time() {
    while (const auto w = next_without_time(jobs_, pieces_, now_)) {
      ++steps_;
      begin_piece(*w, jobs_[*w]);
      end_piece(*w, jobs_[*w]);
    }
  }

  void release(ReleaseClock::Due due) {
    if (options_.profile != timing::Profile::target) return make_ready(due.buckets, due.released);
    const auto count = static_cast<std::int64_t>(due.buckets.size());
    const Duration most = model_.costs.release + count * model_.costs.release_per_bucket;
    Interrupt interrupt{set_.sources.size(), lengths_.draw({}, most), kNothing, std::move(due.buckets), due.released};
    if (random_.one_in(2)) {
      interrupts_.push_back(std::move(interrupt));
    } else {
      interrupts_.push_front(std::move(interrupt));
    }
  }

  void make_ready(const std::vector<std::size_t>& due, Duration released) {
    for (const std::size_t w : due) result_.misses += jobs_[w].released(released);
  }

  void run_interrupt(Duration event) {
    Interrupt& front = interrupts_.front();
    if (front.begin < Duration::zero()) front.begin = now_;
    const Duration end = now_ + front.left;
    if (end > event) {
      front.left = end - event;
      now_ = event;
      return;
    }
    now_ = end;
    const Interrupt done = std::move(front);
    interrupts_.pop_front();
    if (observer_ != nullptr) observer_->interrupt(done.stream, done.begin, now_);
    make_ready(done.due, done.released);
  }

  void run_job(std::size_t w, Duration event) {
    JobState& job = jobs_[w];
    if (!job.piece_begun) {
      begin_piece(w, job);
      if (next_event() <= now_ && job.left > Duration::zero()) return;  // interrupts raised at its start come first
    }
    const Duration end = now_ + job.left;
    if (end <= event) {
      now_ = end;
      end_piece(w, job);
      return;
    }
    job.left = end - event;
    now_ = event;
    // The code at work may have interrupts masked just now.
    if (set_.blocking > Duration::zero() && masked_until_ == Duration::zero() && random_.one_in(2)) {
      masked_until_ = now_ + std::min(random_.between({}, set_.blocking), job.left);
    }
  }

  void begin_piece(std::size_t w, JobState& job) {
    const Pieces& pieces = pieces_[w];
    job.piece_begun = true;
    job.piece_begin = now_;
    if (job.begin < Duration::zero()) job.begin = now_;
    const bool is_update = pieces.is_update(job.piece);
    if (pieces.is_flush(job.piece)) {
      for (Arrivals& a : arrivals_) a.flush_began(w, job.release, now_);
    }
    if (!is_update && !pieces.is_handle(job.piece)) {
      job.left = lengths_.draw({}, pieces.worst(job.piece));
      return;
    }
    const Rank d = pieces.device(job.piece);
    for (Arrivals& a : arrivals_) a.stage_began(d, is_update, job.release, now_);
    job.left = lengths_.draw(least_time(model_.devices[d], is_update, options_.profile), pieces.worst(job.piece));
    if (is_update) update_begin_[d] = now_;
    is_update ? flow_.begin_update(d, now_) : flow_.begin_handle(d, now_);
    reporter_.inputs(d, is_update, now_);
    steps_ += static_cast<std::int64_t>(flow_.width(d));
  }

  void end_piece(std::size_t w, JobState& job) {
    const Pieces& pieces = pieces_[w];
    const bool is_update = pieces.is_update(job.piece);
    if (is_update || pieces.is_handle(job.piece)) end_stage(pieces.device(job.piece), is_update, job);
    job.piece_begun = false;
    if (!pieces.is_last(job.piece++)) return;
    if (observer_ != nullptr) observer_->job(w, job.begin, now_);
    result_.misses += job.end(now_, set_.buckets[w].period);
  }

  void end_stage(Rank d, bool is_update, const JobState& job) {
    Simulation::DeviceWorst& worst = result_.devices[d];
    for (Arrivals& a : arrivals_) a.stage_ended(d, is_update, job.release, now_);
    if (is_update) {
      flow_.end_update(d, now_);
      worst.update_response = std::max(worst.update_response, now_ - job.release);
    } else {
      flow_.end_handle(d, now_, result_.chains);
      worst.response = std::max(worst.response, now_ - job.release);
      worst.window = std::max(worst.window, now_ - update_begin_[d]);
    }
    if (observer_ == nullptr) return;
    observer_->stage(d, is_update ? SimulationObserver::Stage::update : SimulationObserver::Stage::handle,
                     job.piece_begin, now_);
  }

  const timing::Model& model_;
  const SimulationOptions& options_;
  SimulationObserver* observer_;
  timing::Topology topology_;
  timing::TaskSet set_;
  Random random_;
  Lengths lengths_;
  ReleaseClock clock_;
  DataFlow flow_;
  InputReporter reporter_;
  std::vector<Arrivals> arrivals_;  ///< per interrupt source of a bus
  Wires wires_;
  std::deque<Interrupt> interrupts_;
  std::vector<Pieces> pieces_;  ///< of every bucket
  std::vector<JobState> jobs_;
  Table<Rank, Duration> update_begin_;
  std::int64_t steps_ = 0;
  Duration now_;
  Duration masked_until_;
  Simulation result_;
};

}  // namespace

Simulation simulate(const timing::Model& model, const SimulationOptions& options, SimulationObserver* observer) {
  return Simulator(model, options, observer).run();
}

}  // namespace finemote::gen
