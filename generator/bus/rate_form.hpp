// How a tag writes the rate of a bus: `baud="115200baud"`, `clock="400kHz"`, `bitrate="1Mbit/s"`.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "generator/bus/bus_kind.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {

struct RateForm {
  std::string_view attribute;             ///< of the tag: `clock`
  std::array<std::string_view, 3> units;  ///< of one, a thousand and a million of it: `Hz`, `kHz`, `MHz`
  std::string_view page_unit;             ///< in the reference: `Hz`, `bit/s`
  bool has_multiples = true;              ///< hints write it in the largest unit that divides it
  bool is_clock = false;                  ///< parts state the fastest they can do and follow any slower one
  bool has_tolerance = false;             ///< both ends make it by themselves: a port may be a little off
  std::int64_t slowest = 1;               ///< slower than this nobody means [Hz or bit/s]
  std::span<const std::int64_t> usual;    ///< what hints offer, rising [Hz or bit/s]
  units::Result<std::int64_t> (*parse)(std::string_view) = nullptr;
};

extern const RateForm kBaud;
extern const RateForm kClock;
extern const RateForm kBitrate;

/// All of them.
std::span<const RateForm* const> rate_forms();

/// The attribute that holds the rate of a kind of bus: `baud`, `clock`, `bitrate`; empty when the kind has none.
std::string_view rate_attribute(BusKind kind);

/// A rate as the attribute writes it, in the largest unit that divides it: `400kHz`, `1Mbit/s`, `115200baud`. The kind
/// has a rate.
std::string rate_text(BusKind kind, std::int64_t rate);

}  // namespace finemote::gen
