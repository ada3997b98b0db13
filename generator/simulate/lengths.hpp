// How long pieces of work take in a run: in turn for a while at their worst, at their best, and anywhere between.
#pragma once

#include "generator/simulate/streams.hpp"

namespace finemote::gen {

class Lengths {
 public:
  /// `random` is drawn from, and outlives this.
  explicit Lengths(Random& random) : random_(random) {}

  /// Between nothing less than `least` and nothing more than `most`, in the manner of the moment.
  Duration draw(Duration least, Duration most);

 private:
  enum class Manner { worst, best, uniform, extreme, mostly_worst };

  Random& random_;
  Manner manner_ = Manner::worst;
  std::int64_t left_ = 0;  ///< draws until the manner changes
};

}  // namespace finemote::gen
