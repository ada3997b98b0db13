// Ports, rates and buses that could be written instead, for hints that can be pasted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// What limits the rate of a bus besides its port.
struct RateLimits {
  std::optional<std::int64_t> clock;                ///< the fastest of the slowest part
  std::vector<std::vector<std::int64_t>> settings;  ///< of parts that know only some rates
};

/// Rates above `least` that the port makes, rising: the usual ones of the kind, for some also the fastest clock, or
/// those that all parts with settings have.
std::vector<std::int64_t> faster_rates(const Port& port, BusKind kind, std::int64_t least, const RateLimits& limits);

/// The fastest clock up to `most` that the port makes, as the attribute writes it; empty where it makes none, `most`
/// where the port is not known.
std::string fastest_clock(const Port* port, BusKind kind, std::int64_t most);

/// Ports of the board that serve the kind, are not among the `used` ones and need nothing that those occupy.
std::vector<std::string> free_ports(const Board& board, const std::vector<std::string>& used, BusKind kind);

/// `<bus name="can2" type="can" port="can2" bitrate="1Mbit/s"/>` at the first free port that makes the rate (0: none is
/// written), under its own name; empty when there is no such port, and where the board is not known.
std::string another_bus(const Board* board, const std::vector<std::string>& used, BusKind kind, std::int64_t rate);

/// Ports that buses of the robot are at.
std::vector<std::string> used_ports(const Robot& robot);

}  // namespace finemote::gen
