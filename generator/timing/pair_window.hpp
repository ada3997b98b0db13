// From the start of update() of one device to the end of handle() of another, in jobs that are released together.
#pragma once

#include "generator/timing/profile.hpp"

namespace finemote::gen::timing {

class PairWindow {
 public:
  /// Everything must outlive this.
  PairWindow(const ProfileAnalysis& profile, Effort& effort);

  /// Both in one job: W of analysis-cases/README.md for two devices of a bucket.
  [[nodiscard]] Duration in_one_job(Rank from, Rank to, Duration release) const;

  /// In the job of a higher-priority bucket, and in the one of `to` that is released with it. Profile target.
  [[nodiscard]] Duration in_two_jobs(Rank from, Rank to, Duration release) const;

  /// Whether the second one is known of these buckets.
  [[nodiscard]] bool spans(std::size_t from, std::size_t to) const;

 private:
  [[nodiscard]] Duration until(Rank to, Duration release, Duration work, const std::vector<Stream>& streams,
                               const Stages& stages) const;
  [[nodiscard]] std::int64_t releases_inside(std::size_t bucket, std::size_t of, Duration release,
                                             Duration length) const;
  [[nodiscard]] Duration pending_at(std::size_t bucket, std::size_t of, Duration release) const;

  const ProfileAnalysis& profile_;
  Effort& effort_;
  Table<Rank, Duration> updates_from_, handles_to_;  ///< of its bucket: from its stage on, and up to it
};

}  // namespace finemote::gen::timing
