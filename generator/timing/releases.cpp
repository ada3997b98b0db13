#include "generator/timing/releases.hpp"

#include <algorithm>
#include <unordered_map>

#include "generator/timing/repetition.hpp"
#include "generator/timing/surroundings.hpp"

namespace finemote::gen::timing {
ReleaseTable::ReleaseTable(const TaskSet& set, const Responses& responses)
    : bucket_of_(set.bucket_of),
      place_(set.place_of),
      worst_window_(responses.r_minus),
      r_plus_range_(set.bucket_of.size()),
      r_minus_range_(set.bucket_of.size()) {
  for (const TaskBucket& bucket : set.buckets) {
    Bucket table;
    table.period = bucket.period;
    table.general = responses.closed_form[buckets_.size()];
    std::vector<Cell> row;
    for (const Rank d : bucket.devices) {
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
      : set_(set),
        responses_(responses),
        bucket_(set.buckets[w]),
        w_(w),
        higher_(higher_priority_buckets(set, w)),
        effort_(effort),
        whole_(effort),
        inside_(effort) {
    whole_.add_streams(set.in_job(w));
    inside_.add_streams(set.inside_job(w));
    for (const HigherBucket& u : higher_) {
      whole_.add({{}, u.period, u.cost});
      inside_.add({{}, u.period, u.cost, 0});
    }
  }

  void fill(Bucket& table) {
    if (!fill_exactly(table)) fill_general(table);
  }

 private:
  /// Whether that is within the limits.
  bool fill_exactly(Bucket& table) {
    const std::optional<std::int64_t> count = higher_.empty() ? 1 : releases_per_hyperperiod(set_, w_);
    if (!count || *count > effort_.most_releases() || responses_.closed_form[w_]) return false;
    SurroundingsFinder finder(set_, responses_, w_, higher_, effort_);
    table.rows.clear();
    table.first_turn.clear();
    std::unordered_map<Surroundings, std::uint32_t, SurroundingsHash> known;
    for (std::int64_t i = 0; i < *count; ++i) {
      if (effort_.is_spent()) return false;
      const Surroundings& around = finder.of(i * bucket_.period);
      const auto [entry, fresh] = known.emplace(around, static_cast<std::uint32_t>(table.rows.size()));
      if (fresh) {
        table.rows.push_back(row(around));
        table.first_turn.push_back(i);
      }
      table.row_of.push_back(entry->second);
    }
    if (table.rows.size() == 1) table.row_of.clear();
    return !effort_.is_spent();
  }

  /// R of all releases, and windows with as many higher-priority activations as any release can see.
  void fill_general(Bucket& table) {
    table.general = true;
    table.row_of.clear();
    std::vector<Cell> row;
    for (const Rank d : bucket_.devices)
      row.push_back({responses_.r_plus[d], responses_.r_minus[d], responses_.r_minus[d]});
    const std::vector<Duration> firsts(higher_.size(), nanoseconds(1));
    if (!responses_.closed_form[w_]) set_windows(firsts.data(), row);  // else the search would be as long
    table.rows.assign(1, std::move(row));
  }

  std::vector<Cell> row(const Surroundings& around) {
    std::vector<Cell> cells(bucket_.devices.size());
    const std::size_t width = higher_.size() + 1;
    for (std::size_t start = 0; start < around.size(); start += width) sweep(&around[start], cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Rank d = bucket_.devices[i];
      cells[i].r_plus = std::min(cells[i].r_plus, responses_.r_plus[d]);
      cells[i].r_minus = std::min(cells[i].r_minus, responses_.r_minus[d]);
    }
    set_windows(&around[around.size() - width] + 1, cells);
    return cells;
  }

  /// Raises every R of the row to what a busy interval from one start gives.
  void sweep(const Duration* start, std::vector<Cell>& cells) {
    if (!effort_.spend(kStepsPerCell * static_cast<std::int64_t>(cells.size()))) return;
    const Duration distance = *start;
    whole_.begin_at(start + 1);
    Duration x = distance + nanoseconds(1);
    const auto end_of = [&](std::size_t place, Duration work, bool empty) {
      whole_.run({0, place});
      const Duration extra = nanoseconds(empty ? 1 : 0);
      const Duration base = work + extra;
      x = least_fit(whole_, base, std::max(x, base), kLongest);
      return x - extra - distance;
    };
    Duration work = set_.blocking + bucket_.before;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Duration cost = set_.update[bucket_.devices[i]];
      work += cost;
      cells[i].r_plus =
          std::max(cells[i].r_plus, end_of(set_.update_place(bucket_.devices[i]), work, cost == Duration::zero()));
    }
    for (std::size_t i = cells.size(); i-- > 0;) {
      const Duration cost = set_.handle[bucket_.devices[i]];
      work += cost;
      cells[i].r_minus =
          std::max(cells[i].r_minus, end_of(set_.handle_place(bucket_.devices[i]), work, cost == Duration::zero()));
    }
  }

  /// Releases of a higher-priority bucket strictly inside (t, t + length], for lengths that mostly grow.
  class Inside {
   public:
    /// @param first  how much later than t the first release at or after t is
    Inside(const HigherBucket& bucket, Duration first)
        : period_(bucket.period), first_(first == Duration::zero() ? period_ : first) {}
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
  void set_windows(const Duration* firsts, std::vector<Cell>& cells) {
    inside_.rewind();
    std::vector<Inside> inside;
    for (std::size_t u = 0; u < higher_.size(); ++u) inside.emplace_back(higher_[u], firsts[u]);
    Duration work, x = nanoseconds(1), begin = kNever, end;
    for (std::size_t i = cells.size(); i-- > 0;) {
      const Rank d = bucket_.devices[i];
      const Duration extra = nanoseconds(set_.handle[d] == Duration::zero() ? 1 : 0);
      work += set_.update[d] + set_.handle[d];
      const Duration length = cells[i].r_minus - nanoseconds(1) + extra;
      if (length < begin || length > end) {
        begin = length;
        end = kNever;
        for (std::size_t u = 0; u < higher_.size(); ++u) {
          inside_.allow(u, inside[u].count(length));
          end = std::min(end, inside[u].end());
        }
      }
      const Duration base = work + extra;
      inside_.run({set_.update_place(d), set_.handle_place(d)});
      x = least_fit(inside_, base, std::max(x, base), kLongest);
      cells[i].window = std::min(x - extra, cells[i].r_minus);
    }
  }

  const TaskSet& set_;
  const Responses& responses_;
  const TaskBucket& bucket_;
  std::size_t w_;
  static constexpr std::int64_t kStepsPerCell = 16;

  std::vector<HigherBucket> higher_;
  Effort& effort_;
  Demand whole_;   ///< all higher-priority demand
  Demand inside_;  ///< all higher-priority demand that is released inside a window
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

Table<Rank, bool> general_up_to_root(const Model& model, const TaskSet& set, const ReleaseTable& table) {
  Table<Rank, bool> is_general(model.devices.size());
  for (std::size_t i = model.devices.size(); i-- > 0;) {  // parents come after their children
    const Rank d{i};
    const auto parent = model.devices[d].parent;
    is_general[d] = table.is_general(set.bucket_of[d]) || (parent && is_general[*parent]);
  }
  return is_general;
}

}  // namespace finemote::gen::timing
