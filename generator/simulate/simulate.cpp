#include "generator/simulate/simulate.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "generator/simulate/data_flow.hpp"
#include "generator/simulate/lengths.hpp"
#include "generator/simulate/streams.hpp"
#include "generator/timing/task_set.hpp"

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

/// The job of one bucket: entry, updates forward, handles backward, flush.
struct JobState {
  bool active = false;
  Duration release;
  Duration begin = kNothing;
  std::size_t piece = 0;  ///< 0 entry, 1..n updates, n+1..2n handles, 2n+1 flush
  bool piece_begun = false;
  Duration piece_begin;
  Duration left;
  std::optional<Duration> next;  ///< the next release, which found the job unfinished

  void start(Duration at) {
    *this = {};
    active = true;
    release = at;
  }

  /// A release of the bucket. Returns how many releases are skipped by it: one can wait.
  std::int64_t released(Duration at) {
    if (!active) return start(at), 0;
    if (next) return 1;
    next = at;
    return 0;
  }

  /// The job ends; how many jobs it spoils: itself when it is late, and the one that waits. It may end at the very
  /// release of the next one, as stages of zero length still have to be dispatched there.
  std::int64_t end(Duration now, Duration period) {
    active = false;
    const bool is_late = now - release > period;
    if (is_late) return next ? 2 : 1;
    if (next) start(*next);
    return 0;
  }
};

/// When buckets are released: each once per period, from time 0 on.
class ReleaseClock {
 public:
  /// What is released together.
  struct Due {
    std::vector<std::size_t> buckets;
    Duration released;  ///< when the last of them was due
  };

  explicit ReleaseClock(const std::vector<timing::TaskBucket>& buckets) : buckets_(buckets), next_(buckets.size()) {}

  /// The next release of all.
  [[nodiscard]] Duration next() const {
    const auto soonest = std::min_element(next_.begin(), next_.end());
    return soonest == next_.end() ? Duration::max() : *soonest;
  }
  [[nodiscard]] Duration next_of(std::size_t bucket) const { return next_[bucket]; }

  /// Everything that is due at `now`.
  Due take(Duration now) {
    Due due;
    for (std::size_t w = 0; w < next_.size(); ++w) {
      if (next_[w] > now) continue;
      due.buckets.push_back(w);
      due.released = next_[w];
      next_[w] += buckets_[w].period;
    }
    return due;
  }

 private:
  const std::vector<timing::TaskBucket>& buckets_;
  std::vector<Duration> next_;
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

/// One processor: interrupts before jobs, jobs by the rank of their buckets.
class Simulator {
 public:
  Simulator(const timing::Model& model, const SimulationOptions& options, SimulationObserver* observer)
      : model_(model),
        options_(options),
        observer_(observer),
        topology_(timing::make_topology(model)),
        set_(timing::make_task_set(model, options.profile)),
        random_(options.seed),
        lengths_(random_),
        clock_(set_.buckets),
        flow_(model, topology_, options.chains),
        reporter_(model, topology_, flow_, observer),
        jobs_(set_.buckets.size()),
        update_begin_(model.devices.size()) {
    result_.devices.resize(model.devices.size());
    for (const ChainEnds& ends : options.chains) result_.chains.push_back({ends, kNothing});
    for (std::size_t s = 0; s < set_.bus_streams; ++s) {
      arrivals_.emplace_back(set_.streams[s], set_.buckets.back().period, random_);
    }
  }

  Simulation run() {
    while (now_ < options_.duration) {
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
    return std::move(result_);
  }

 private:
  [[nodiscard]] Duration next_event() const {
    Duration event = clock_.next();
    for (const ArrivalGenerator& a : arrivals_) event = std::min(event, a.next());
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
      while (arrivals_[s].next() <= now_) {
        interrupts_.push_back({s, lengths_.draw({}, set_.streams[s].cost), kNothing, {}, {}});
        const auto w = static_cast<std::size_t>(random_.between(0, static_cast<std::int64_t>(jobs_.size()) - 1));
        arrivals_[s].advance(clock_.next_of(w));
      }
    }
    ReleaseClock::Due due = clock_.take(now_);
    if (!due.buckets.empty()) release(std::move(due));
  }

  void release(ReleaseClock::Due due) {
    if (options_.profile != timing::Profile::target) return make_ready(due.buckets, due.released);
    const auto count = static_cast<std::int64_t>(due.buckets.size());
    const Duration most = model_.costs.release + count * model_.costs.release_per_bucket;
    Interrupt interrupt{set_.bus_streams, lengths_.draw({}, most), kNothing, std::move(due.buckets), due.released};
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
    if (!job.piece_begun) begin_piece(w, job);
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

  /// The device of a piece; pieces 1..n are updates, n+1..2n handles in reverse order.
  [[nodiscard]] Rank device_of(std::size_t w, std::size_t piece) const {
    const auto& devices = set_.buckets[w].devices;
    return piece <= devices.size() ? devices[piece - 1] : devices[2 * devices.size() - piece];
  }

  void begin_piece(std::size_t w, JobState& job) {
    const std::size_t n = set_.buckets[w].devices.size();
    job.piece_begun = true;
    job.piece_begin = now_;
    if (job.begin < Duration::zero()) job.begin = now_;
    if (job.piece == 0 || job.piece > 2 * n) {
      job.left = lengths_.draw({}, job.piece == 0 ? set_.buckets[w].before : set_.buckets[w].after);
      return;
    }
    const Rank d = device_of(w, job.piece);
    const bool is_update = job.piece <= n;
    const timing::Device& device = model_.devices[d];
    const bool target = options_.profile == timing::Profile::target;
    job.left = is_update ? lengths_.draw(target ? device.update_bcet : Duration::zero(), set_.update[d])
                         : lengths_.draw(target ? device.handle_bcet : Duration::zero(), set_.handle[d]);
    if (is_update) {
      update_begin_[d] = now_;
      flow_.begin_update(d, now_);
    } else {
      flow_.begin_handle(d, now_);
    }
    reporter_.inputs(d, is_update, now_);
  }

  void end_piece(std::size_t w, JobState& job) {
    const std::size_t n = set_.buckets[w].devices.size();
    if (job.piece >= 1 && job.piece <= 2 * n) end_stage(device_of(w, job.piece), job.piece <= n, job);
    job.piece_begun = false;
    const std::size_t last = set_.buckets[w].after > Duration::zero() ? 2 * n + 1 : 2 * n;
    if (job.piece++ < last) return;
    if (observer_ != nullptr) observer_->job(w, job.begin, now_);
    result_.misses += job.end(now_, set_.buckets[w].period);
  }

  void end_stage(Rank d, bool is_update, const JobState& job) {
    Simulation::DeviceWorst& worst = result_.devices[d];
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
  std::vector<ArrivalGenerator> arrivals_;
  std::deque<Interrupt> interrupts_;
  std::vector<JobState> jobs_;
  Table<Rank, Duration> update_begin_;
  Duration now_;
  Duration masked_until_;
  Simulation result_;
};

}  // namespace

Simulation simulate(const timing::Model& model, const SimulationOptions& options, SimulationObserver* observer) {
  return Simulator(model, options, observer).run();
}

}  // namespace finemote::gen
