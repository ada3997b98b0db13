#include "generator/timing/releases.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::timing {
namespace {

constexpr std::int64_t kMostReleases = 1'000'000;  ///< of one bucket in its least common multiple
constexpr std::size_t kMostCells = 1U << 23;       ///< of one bucket: 200 MB

/// What surrounds a release: for each instant t0 from which more urgent work may be pending (the release itself comes
/// last), its distance and the first release of every more urgent bucket from it on.
struct Surroundings {
  struct Start {
    Duration distance;             ///< t - t0
    std::vector<Duration> firsts;  ///< per more urgent bucket: first release at or after t0, less t0
    friend auto operator<=>(const Start&, const Start&) = default;
  };
  std::vector<Start> starts;
  friend auto operator<=>(const Surroundings&, const Surroundings&) = default;
};

}  // namespace

ReleaseTable::ReleaseTable(const TaskSet& set, const Responses& responses)
    : bucket_of_(set.bucket_of),
      place_(set.bucket_of.size()),
      worst_window_(responses.r_minus),
      r_plus_range_(set.bucket_of.size()),
      r_minus_range_(set.bucket_of.size()) {
  for (const TaskBucket& bucket : set.buckets) {
    Bucket table;
    table.period = bucket.period;
    std::vector<Cell> row;
    for (const Rank d : bucket.devices) {
      place_[d] = row.size();
      row.push_back({responses.r_plus[d], responses.r_minus[d], responses.r_minus[d]});
      r_plus_range_[d] = {responses.r_plus[d], responses.r_plus[d]};
      r_minus_range_[d] = {responses.r_minus[d], responses.r_minus[d]};
    }
    table.rows.push_back(std::move(row));
    buckets_.push_back(std::move(table));
  }
}

std::size_t ReleaseTable::row(Rank device, Duration release) const {
  const Bucket& bucket = buckets_[bucket_of_[device]];
  if (bucket.row_of.empty()) return 0;
  return bucket.row_of[static_cast<std::size_t>(bucket.by_count.rest(bucket.by_period.floor(release.ns())))];
}

const ReleaseTable::Cell& ReleaseTable::cell(Rank device, Duration release) const {
  return buckets_[bucket_of_[device]].rows[row(device, release)][place_[device]];
}

Duration ReleaseTable::repeat(Rank device) const {
  const Bucket& bucket = buckets_[bucket_of_[device]];
  return bucket.row_of.empty() ? bucket.period : bucket.period * static_cast<std::int64_t>(bucket.row_of.size());
}

/// Fills the rows of one bucket.
class ReleaseTable::Builder {
 public:
  Builder(const TaskSet& set, const Responses& responses, std::size_t w, Effort& effort)
      : set_(set), responses_(responses), bucket_(set.buckets[w]), w_(w), effort_(effort), demand_(effort) {
    for (std::size_t v = 0; v < w; ++v) {
      if (set.buckets[v].cost > Duration::zero()) urgent_.push_back({set.buckets[v].period, set.buckets[v].cost});
    }
    demand_.add_streams(set.streams);
  }

  void fill(Bucket& table) {
    Duration common = bucket_.period;
    for (std::size_t v = 0; v < w_; ++v) common = lcm(common, set_.buckets[v].period);
    const std::int64_t count = floor_div(common, bucket_.period);
    find_longest_busy();
    table.rows.clear();
    if (count > kMostReleases) return fill_general(table);
    std::map<Surroundings, std::uint32_t> known;
    for (std::int64_t i = 0; i < count; ++i) {
      const Surroundings around = surroundings(i * bucket_.period);
      const auto [entry, fresh] = known.emplace(around, static_cast<std::uint32_t>(table.rows.size()));
      if (fresh) {
        if ((table.rows.size() + 1) * bucket_.devices.size() > kMostCells) return fill_general(table);
        table.rows.push_back(row(around));
      }
      table.row_of.push_back(entry->second);
      effort_.spend(16);
    }
    if (table.rows.size() == 1) table.row_of.clear();
  }

 private:
  struct Urgent {
    Duration period = nanoseconds(1);
    Duration cost;
  };

  /// R of all releases, and windows with as many more urgent activations as any release can see.
  void fill_general(Bucket& table) {
    table.general = true;
    table.row_of.clear();
    std::vector<Cell> row;
    for (const Rank d : bucket_.devices) row.push_back({responses_.r_plus[d], responses_.r_minus[d], kNone});
    Surroundings worst;
    worst.starts.push_back({{}, std::vector<Duration>(urgent_.size(), nanoseconds(1))});
    set_windows(worst.starts.back().firsts, row);
    table.rows.assign(1, std::move(row));
  }

  /// No more urgent work of buckets and streams stays pending for longer than this.
  void find_longest_busy() {
    demand_.clear_terms();
    for (const Urgent& u : urgent_) demand_.add({{}, u.period, u.cost});
    longest_busy_ = urgent_.empty() ? Duration::zero() : least_fit(demand_, set_.blocking, nanoseconds(1), kLongest);
  }

  Surroundings::Start start_at(Duration t0, Duration t) const {
    Surroundings::Start start{t - t0, {}};
    const Duration horizon = t - t0 + responses_.bucket[w_] + nanoseconds(2);  // later releases cannot matter
    for (const Urgent& u : urgent_) start.firsts.push_back(std::min(round_up(t0, u.period) - t0, horizon));
    return start;
  }

  void use(const Surroundings::Start& start) {
    demand_.clear_terms();
    for (std::size_t i = 0; i < urgent_.size(); ++i) demand_.add({start.firsts[i], urgent_[i].period, urgent_[i].cost});
  }

  /// Whether more urgent work released from t0 on keeps the processor busy beyond t.
  bool stays_busy(const Surroundings::Start& start) {
    use(start);
    return least_fit(demand_, set_.blocking, nanoseconds(1), start.distance) == kNever;
  }

  Surroundings surroundings(Duration t) {
    Surroundings around;
    for (const Urgent& u : urgent_) {
      if (gcd(u.period, bucket_.period) >= longest_busy_) continue;  // none is that near
      for (Duration t0 = round_down(t - nanoseconds(1), u.period); t - t0 < longest_busy_; t0 -= u.period) {
        Surroundings::Start start = start_at(t0, t);
        if (stays_busy(start)) around.starts.push_back(std::move(start));
      }
    }
    std::sort(around.starts.begin(), around.starts.end(), std::greater<>());
    around.starts.erase(std::unique(around.starts.begin(), around.starts.end()), around.starts.end());
    around.starts.push_back(start_at(t, t));
    return around;
  }

  std::vector<Cell> row(const Surroundings& around) {
    std::vector<Cell> cells(bucket_.devices.size());
    for (const Surroundings::Start& start : around.starts) sweep(start, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Rank d = bucket_.devices[i];
      cells[i].r_plus = std::min(cells[i].r_plus, responses_.r_plus[d]);
      cells[i].r_minus = std::min(cells[i].r_minus, responses_.r_minus[d]);
    }
    set_windows(around.starts.back().firsts, cells);
    return cells;
  }

  /// Raises every R of the row to what a busy interval from one start gives.
  void sweep(const Surroundings::Start& start, std::vector<Cell>& cells) {
    use(start);
    Duration x = start.distance + nanoseconds(1);
    const auto end_of = [&](Duration work, bool empty) {
      const Duration extra = nanoseconds(empty ? 1 : 0);
      const Duration base = work + extra;
      x = least_fit(demand_, base, std::max(x, base), kLongest);
      return x - extra - start.distance;
    };
    Duration work = set_.blocking + bucket_.before;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Duration cost = set_.update[bucket_.devices[i]];
      work += cost;
      cells[i].r_plus = std::max(cells[i].r_plus, end_of(work, cost == Duration::zero()));
    }
    for (std::size_t i = cells.size(); i-- > 0;) {
      const Duration cost = set_.handle[bucket_.devices[i]];
      work += cost;
      cells[i].r_minus = std::max(cells[i].r_minus, end_of(work, cost == Duration::zero()));
    }
  }

  /// Releases of a more urgent bucket strictly inside (t, t + length], for lengths that mostly grow.
  class Inside {
   public:
    /// @param first  how much later than t the first release at or after t is
    Inside(const Urgent& urgent, Duration first)
        : period_(urgent.period), first_(first == Duration::zero() ? period_ : first) {}
    /// Up to which length there are no more of them.
    [[nodiscard]] Duration end() const { return end_; }
    std::int64_t count(Duration length) {
      if (length >= begin_ && length <= end_) return count_;
      count_ = length < first_ ? 0 : floor_div(length - first_, period_) + 1;
      begin_ = count_ == 0 ? Duration::zero() : first_ + (count_ - 1) * period_;
      const Duration before_next = period_ - nanoseconds(1);
      if (count_ == 0) {
        end_ = first_ - nanoseconds(1);
      } else {
        end_ = begin_ > kNever - before_next ? kNever : begin_ + before_next;
      }
      return count_;
    }

   private:
    Duration period_, first_;
    std::int64_t count_ = 0;
    Duration begin_ = nanoseconds(1), end_;  ///< lengths with this count
  };

  /// Windows from R-(t), from the last device (the shortest window) to the first.
  void set_windows(const std::vector<Duration>& firsts, std::vector<Cell>& cells) {
    demand_.clear_terms();
    std::vector<Inside> inside;
    for (std::size_t u = 0; u < urgent_.size(); ++u) {
      demand_.add({{}, urgent_[u].period, urgent_[u].cost, 0});
      inside.emplace_back(urgent_[u], firsts[u]);
    }
    Duration work, x = nanoseconds(1), begin = kNever, end;
    for (std::size_t i = cells.size(); i-- > 0;) {
      const Rank d = bucket_.devices[i];
      const Duration extra = nanoseconds(set_.handle[d] == Duration::zero() ? 1 : 0);
      work += set_.update[d] + set_.handle[d];
      const Duration length = cells[i].r_minus - nanoseconds(1) + extra;
      if (length < begin || length > end) {
        begin = length;
        end = kNever;
        for (std::size_t u = 0; u < urgent_.size(); ++u) {
          demand_.allow(u, inside[u].count(length));
          end = std::min(end, inside[u].end());
        }
      }
      const Duration base = work + extra;
      x = least_fit(demand_, base, std::max(x, base), kLongest);
      cells[i].window = std::min(x - extra, cells[i].r_minus);
    }
  }

  const TaskSet& set_;
  const Responses& responses_;
  const TaskBucket& bucket_;
  std::size_t w_;
  Effort& effort_;
  Demand demand_;
  std::vector<Urgent> urgent_;  ///< shorter periods of nonzero cost
  Duration longest_busy_;
};

ReleaseTable ReleaseTable::refined(const TaskSet& set, const Responses& responses, Effort& effort) {
  ReleaseTable table(set, responses);
  for (std::size_t w = 0; w < set.buckets.size(); ++w) {
    if (!responses.ok(w)) continue;
    Bucket& bucket = table.buckets_[w];
    Builder(set, responses, w, effort).fill(bucket);
    bucket.by_period = Divider(bucket.period.ns());
    bucket.by_count = Divider(std::max<std::int64_t>(static_cast<std::int64_t>(bucket.row_of.size()), 1));
    const auto widen = [](Range& range, Duration value) {
      range = {std::min(range.least, value), std::max(range.most, value)};
    };
    for (const Rank d : set.buckets[w].devices) {
      const Cell& first = bucket.rows.front()[table.place_[d]];
      table.worst_window_[d] = {};
      table.r_plus_range_[d] = {first.r_plus, first.r_plus};
      table.r_minus_range_[d] = {first.r_minus, first.r_minus};
    }
    for (const auto& row : bucket.rows) {
      for (const Rank d : set.buckets[w].devices) {
        const Cell& cell = row[table.place_[d]];
        table.worst_window_[d] = std::max(table.worst_window_[d], cell.window);
        widen(table.r_plus_range_[d], cell.r_plus);
        widen(table.r_minus_range_[d], cell.r_minus);
      }
    }
  }
  return table;
}

}  // namespace finemote::gen::timing
