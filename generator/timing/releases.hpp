// Response times and windows of every release: what the known phases of the buckets make of the general bounds.
#pragma once

#include "generator/timing/response.hpp"
#include "generator/units/divider.hpp"

namespace finemote::gen::timing {

/// Bounds per device and release. Releases with the same arrivals around them share one row.
class ReleaseTable {
 public:
  /// R and W that hold for every release alone (profile paper has no windows: they equal R).
  ReleaseTable(const TaskSet& set, const Responses& responses);

  /// R(t) and W(t) of analysis-cases/README.md, profile `tight`. Buckets beyond the limits keep bounds that hold for
  /// every release, and are listed by `is_general`. Throws Overflow.
  static ReleaseTable refined(const TaskSet& set, const Responses& responses, Effort& effort);

  [[nodiscard]] Duration r_plus(Rank device, Duration release) const { return cell(device, release).r_plus; }
  [[nodiscard]] Duration r_minus(Rank device, Duration release) const { return cell(device, release).r_minus; }
  [[nodiscard]] Duration window(Rank device, Duration release) const { return cell(device, release).window; }
  /// Worst window over all releases; kNone when the bucket is not ok.
  [[nodiscard]] Duration window(Rank device) const { return worst_window_[device]; }

  /// Rows of a device's bucket, and which one a release has.
  [[nodiscard]] std::size_t rows(Rank device) const { return buckets_[bucket_of_[device]].rows.size(); }
  [[nodiscard]] std::size_t row(Rank device, Duration release) const;
  /// The same in two steps, for those who go from release to release: its turn in one repetition, and the row of a
  /// turn. Only where there is more than one row.
  [[nodiscard]] std::size_t turns(Rank device) const { return buckets_[bucket_of_[device]].row_of.size(); }
  [[nodiscard]] std::size_t turn(Rank device, Duration release) const {
    const Bucket& bucket = buckets_[bucket_of_[device]];
    return static_cast<std::size_t>(bucket.by_count.rest(bucket.by_period.floor(release.ns())));
  }
  [[nodiscard]] std::size_t row_of_turn(Rank device, std::size_t turn) const {
    return buckets_[bucket_of_[device]].row_of[turn];
  }
  /// A release with that row.
  [[nodiscard]] Duration release_of_row(Rank device, std::size_t row) const {
    const Bucket& bucket = buckets_[bucket_of_[device]];
    return bucket.row_of.empty() ? Duration::zero() : bucket.first_turn[row] * bucket.period;
  }
  [[nodiscard]] Duration r_plus_in_row(Rank device, std::size_t row) const {
    return buckets_[bucket_of_[device]].rows[row][place_[device]].r_plus;
  }
  [[nodiscard]] Duration r_minus_in_row(Rank device, std::size_t row) const {
    return buckets_[bucket_of_[device]].rows[row][place_[device]].r_minus;
  }

  /// Smallest and largest value over all rows.
  struct Range {
    Duration least = kNone, most = kNone;
  };
  [[nodiscard]] Range r_plus_range(Rank device) const { return r_plus_range_[device]; }
  [[nodiscard]] Range r_minus_range(Rank device) const { return r_minus_range_[device]; }

  [[nodiscard]] Duration window_in_row(Rank device, std::size_t row) const {
    return buckets_[bucket_of_[device]].rows[row][place_[device]].window;
  }

  /// After what time the rows of a device's bucket repeat: its period when all releases are alike.
  [[nodiscard]] Duration repeat(Rank device) const;
  [[nodiscard]] bool is_general(std::size_t bucket) const { return buckets_[bucket].general; }

 private:
  struct Cell {
    Duration r_plus = kNone, r_minus = kNone, window = kNone;
  };
  struct Bucket {
    Duration period = nanoseconds(1);
    std::vector<std::uint32_t> row_of;  ///< per release in one repetition; empty: row 0 always
    std::vector<std::vector<Cell>> rows;
    std::vector<std::int64_t> first_turn;  ///< of every row
    bool general = false;
    Divider by_period, by_count;  ///< of period and row_of.size()
  };
  class Builder;

  [[nodiscard]] const Cell& cell(Rank device, Duration release) const;

  std::vector<Bucket> buckets_;
  Table<Rank, std::size_t> bucket_of_, place_;  ///< of a device: its bucket and its place in it
  Table<Rank, Duration> worst_window_;
  Table<Rank, Range> r_plus_range_, r_minus_range_;
};

/// Of every device, whether its bucket or one of a device above it in its tree `is_general`: exact answers about its
/// paths are then exact about these bounds only.
Table<Rank, bool> general_up_to_root(const Model& model, const TaskSet& set, const ReleaseTable& table);

}  // namespace finemote::gen::timing
