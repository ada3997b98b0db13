// How long the rest of a job can take from a place in it on: until what it has computed leaves the processor.
#pragma once

#include <functional>

#include <cstddef>
#include <vector>

#include "generator/timing/response.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

class RestOfJob {
 public:
  /// Everything must outlive this.
  RestOfJob(const TaskSet& set, const Responses& responses, Effort& effort)
      : set_(set), responses_(responses), effort_(effort) {}

  /// Nothing of higher priority is pending where the place is passed: only what arrives later counts, and the job's own
  /// work.
  /// @param bucket  whose jobs meet their deadlines
  /// @param work    of the job after the place, masked sections included
  /// @param stage   the first one after the place (raised.hpp)
  /// @param latest  when the place is passed at the latest, after the release
  /// @param of      the same of the job released then; never larger
  [[nodiscard]] Duration from(std::size_t bucket, Duration work, std::size_t stage, Duration latest,
                              const std::function<Duration(Duration release)>& of) const;

 private:
  /// Whether the stages of a job from this one on raise interrupts, or earlier ones still do.
  [[nodiscard]] bool asks(std::size_t bucket, std::size_t stage) const;
  /// From an instant on, given as a time since the common first release of all buckets; 0 is the worst one.
  [[nodiscard]] Duration at(std::size_t bucket, Duration work, std::size_t stage, Duration instant) const;
  [[nodiscard]] std::vector<Duration> instants_of(std::size_t bucket, Duration release, Duration latest) const;
  /// How many instants there are to look at; more than the most there may be where that is not known.
  [[nodiscard]] std::int64_t instants(std::size_t bucket, Duration repeat, Duration latest) const;

  const TaskSet& set_;
  const Responses& responses_;
  Effort& effort_;
};

}  // namespace finemote::gen::timing
