// What the buses mean for chains: the age of samples, and the way of commands to their outputs.
#pragma once

#include <functional>

#include "generator/timing/profile.hpp"
#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {

/// From the end of a stage to the output, and from a sample to the stage: what a robot's transfers mean for its chains.
class WireAnalysis {
 public:
  WireAnalysis(const Model& model, const ProfileAnalysis& profile, Effort& effort);

  /// From the end of a flush's job to the last bit that carries what the job computed; none where unbounded.
  [[nodiscard]] std::optional<Duration> flush_response(std::size_t flush) const;

  /// End of handle(to) to the last bit of its command; 0 where no bus carries one; none where unbounded.
  [[nodiscard]] std::optional<Duration> command(Rank to) const;

  /// Age of a sample when update(from) begins; 0 without acquisition data; none where unbounded.
  [[nodiscard]] std::optional<Duration> acquisition(Rank from) const;
  /// The same of every device.
  [[nodiscard]] Table<Rank, std::optional<Duration>> acquisitions() const;

  [[nodiscard]] const Table<BusPlace, BusLoad>& loads() const { return transfers_.loads(); }
  [[nodiscard]] const TransferBounds& transfers() const { return transfers_; }

 private:
  [[nodiscard]] std::optional<Duration> streamed(Rank from) const;
  [[nodiscard]] std::optional<Duration> asked(Rank from) const;
  [[nodiscard]] std::optional<Duration> asked_at(Rank device, const Transfer& transfer) const;
  [[nodiscard]] std::optional<std::int64_t> jobs_to_wait(Rank device, std::int64_t slot) const;
  [[nodiscard]] bool is_in_the_way(Rank from) const;
  [[nodiscard]] std::optional<Duration> rest_of_job(Rank device) const;
  [[nodiscard]] Duration stage_end(Rank device, Transfer::After stage) const;
  [[nodiscard]] std::optional<Duration> stage_after(Rank device, Transfer::After stage, std::int64_t jobs) const;
  [[nodiscard]] std::optional<Duration> end_of_next_job(Rank device) const;
  [[nodiscard]] std::optional<Duration> end_of_job(std::size_t bucket, Duration handles, std::size_t stage,
                                                   Duration latest,
                                                   const std::function<Duration(Duration release)>& of) const;

  const Model& model_;
  const ProfileAnalysis& profile_;
  Effort& effort_;
  TransferBounds transfers_;
};

}  // namespace finemote::gen::timing
