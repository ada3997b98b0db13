// How old a sample can be when `update()` publishes it: `acquisition` of a device descriptor.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// How long a part measures: always the same, or by the value of a param.
struct Conversion {
  Duration fixed;
  std::string param;                         ///< empty: `fixed` counts
  std::map<std::string, Duration> by_value;  ///< by the value as the URDF spells it

  /// The longest of all values.
  [[nodiscard]] Duration longest() const;
};

/// How far the clock of a part may be off where its descriptor does not say: that of a resonator, ageing and cold
/// included.
inline constexpr std::int64_t kUsualTolerancePpm = 10'000;

struct Acquisition {
  enum class Model {
    streamed,  ///< the part sends by itself
    polled,    ///< the device starts each measurement
  };
  Model model = Model::polled;
  Duration latency;                                 ///< inside the part: filters, averaging
  std::optional<Duration> interval;                 ///< streamed: from one frame to the next, by the part's own clock
  std::string interval_param;                       ///< the param whose value it is; empty: `interval` counts
  std::int64_t tolerance_ppm = kUsualTolerancePpm;  ///< how far that clock may be off, both ways
  std::optional<std::int64_t> periods;      ///< polled: own periods from the start of a measurement to its update()
  std::optional<std::int64_t> begun_every;  ///< polled: own periods from one start to the next; none: `periods`
  std::int64_t published_every = 1;         ///< polled: a fresh value at least once in this many measurements
  std::optional<Conversion> conversion;     ///< polled
  std::int64_t conversions = 1;             ///< polled: one after the other, in one measurement
  Duration bring_up = seconds(1);           ///< from the first release to the first sample, at most
};

/// Reads a member that the schema accepts.
Acquisition read_acquisition(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
