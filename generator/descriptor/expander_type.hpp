// What an expander is, as its JSON descriptor says (`schemas/expanders/<model>.json`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/emulation.hpp"
#include "generator/descriptor/frames.hpp"
#include "generator/descriptor/mux_select.hpp"
#include "generator/descriptor/param.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// How often the pulses of an expander repeat: its clock over `counts` and a whole divider.
struct RepeatSpec {
  std::string frequency, clock;  ///< names of params [Hz]
  std::int64_t counts = 1;       ///< of the longest pulse
  std::int64_t least_divider = 1, most_divider = 1;
};

/// How long a driver's flush() takes at most.
struct FlushTime {
  Duration once, per_channel;  ///< `per_channel`: from the first to the last that is used
};

/// A part that provides buses and is no device.
struct ExpanderType {
  enum class Kind {
    mux,     ///< each `<channel>` is a segment of the bus it sits on; no object, but the way of what is behind it
    driver,  ///< an object with a slot, which is itself the bus and is flushed at the end of a bucket
  };
  std::string name;  ///< the `model` attribute: `tca9548a`
  std::string summary;
  Kind kind = Kind::mux;
  const MuxSelect* select = nullptr;  ///< of a mux
  std::string cpp_class;              ///< of a driver
  std::string header;                 ///< as the descriptor names it, relative to its file
  std::string include;                ///< as generated code includes it
  std::string include_dir;            ///< folder to add to the include path for a user's; empty for shipped ones
  std::string display_path;           ///< `builtin:expanders/pca9685.json`, or relative to the input
  bool builtin = true;
  std::vector<std::uint32_t> addresses;  ///< allowed ones; empty: any
  std::optional<std::int64_t> max_clock_hz;
  BusKind provides = {};
  std::uint32_t channels = 0;
  std::optional<RepeatSpec> repeats;  ///< pwm
  bool is_suggested = false;          ///< what hints and examples name
  std::vector<ParamSpec> params;
  ExpanderFrames frames;
  std::optional<FlushTime> flush;  ///< of a driver; none: as the costs of the board say of the shipped one
  Emulation emulation;

  [[nodiscard]] bool is_mux() const { return kind == Kind::mux; }
};

}  // namespace finemote::gen
