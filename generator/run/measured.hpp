// One figure of a run beside the bound it is held to.
#pragma once

#include <optional>
#include <string_view>

#include "generator/run/record.hpp"
#include "generator/run/statistics.hpp"

namespace finemote::gen {

/// What a run says of a bound.
enum class Judgement { held, broken, no_sample, no_bound };

/// `held`, `broken`, `no-sample`, `no-bound`.
std::string_view judgement_name(Judgement judgement);

struct Measured {
  Statistics observed;
  std::optional<Duration> bound;
  bool was_broken = false;  ///< before a scenario violated any assumption: nothing excuses that

  [[nodiscard]] Judgement judged() const {
    if (!bound) return Judgement::no_bound;
    if (observed.count == 0) return Judgement::no_sample;
    return observed.max <= *bound ? Judgement::held : Judgement::broken;
  }
};

/// One of the figures of `Of`, by its name in tables.
template <class Of>
struct Figure {
  const char* name;
  Measured Of::*measured;
};

}  // namespace finemote::gen
