// Interrupts of one stream, whatever causes them.
#pragma once

#include <variant>

#include "generator/simulate/caused_arrivals.hpp"
#include "generator/simulate/streams.hpp"

namespace finemote::gen {

class Arrivals {
 public:
  /// Everything must outlive this.
  Arrivals(const timing::Stream& stream, const timing::TaskSet& set, Random& random)
      : kind_(kind_of(stream, set, random)) {}

  [[nodiscard]] Duration next() const {
    return std::visit([](const auto& arrivals) { return arrivals.next(); }, kind_);
  }
  /// Called when `next()` has arrived; `release` is an instant at which some bucket is released later.
  void advance(Duration release) {
    std::visit([&](auto& arrivals) { arrivals.advance(release); }, kind_);
  }
  /// A stage of the job released at `release` begins now.
  void stage_began(Rank device, bool is_update, Duration release, Duration now) {
    if (auto* caused = std::get_if<CausedArrivals>(&kind_)) caused->stage_began(device, is_update, release, now);
  }
  /// It has ended now.
  void stage_ended(Rank device, bool is_update, Duration release, Duration now) {
    if (auto* caused = std::get_if<CausedArrivals>(&kind_)) caused->stage_ended(device, is_update, release, now);
  }
  /// All handles of the bucket's job released at `release` have ended now.
  void flush_began(std::size_t bucket, Duration release, Duration now) {
    if (auto* caused = std::get_if<CausedArrivals>(&kind_)) caused->flush_began(bucket, release, now);
  }

 private:
  using Kind = std::variant<ArrivalGenerator, CausedArrivals>;
  static Kind kind_of(const timing::Stream& stream, const timing::TaskSet& set, Random& random) {
    if (CausedArrivals::cause(stream)) return CausedArrivals(stream, set, random);
    return ArrivalGenerator(stream, set.buckets.back().period, random);
  }

  Kind kind_;
};

}  // namespace finemote::gen
