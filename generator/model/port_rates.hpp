// Which rates a port makes: by the rule of its chip, or of the list in its board file.
#pragma once

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// The rule by which the port makes rates for a bus of the kind: its own, else the usual one; null: it makes every rate
/// in its range.
const RateRule* rule_of(const Port& port, BusKind kind);

/// Whether the port makes few enough rates to list them.
bool has_few_rates(const Port& port, BusKind kind);

/// The rate nearest to the one asked for that the port can make; `wanted` is above 0 [Hz or bit/s].
double nearest_rate(const Port& port, BusKind kind, double wanted);

/// What the driver of the port makes of a rate, which need not be the nearest: an SPI clock is never faster than asked
/// for.
double made_rate(const Port& port, BusKind kind, double wanted);

/// What the port makes of a rate at its slowest, for times on the wire.
std::int64_t slowest_rate(const Port& port, BusKind kind, std::int64_t wanted);

/// How far what the port makes is from what is asked for, as a fraction of that.
double rate_error(const Port& port, BusKind kind, double wanted);

/// Whether the port makes the rate, nearly enough.
bool is_made(const Port& port, BusKind kind, std::int64_t rate);

}  // namespace finemote::gen
