// What could be written at a bus instead, judged by the devices that say they sit on it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/model/reading.hpp"

namespace finemote::gen {

/// Ports that can serve the kind; all ports when the kind is not known.
std::vector<std::string> ports_for(const Board& board, std::optional<BusKind> kind);

/// Of these ports, those that no bus of the robot names, whether it stands before or after; all when none is left.
std::vector<std::string> unclaimed(const Reading& reading, const std::vector<std::string>& ports);

/// The port offered to a bus that names none; nothing where the board has none of the kind.
std::string example_port(const Reading& reading, std::optional<BusKind> kind);

/// Types of the devices that say they sit on the bus, as far as there are such types.
std::vector<const DeviceType*> types_on(Reading& reading, std::string_view bus);

/// The fastest clock that all devices on the bus can do [Hz]; INT64_MAX where none limits it.
std::int64_t clock_of_parts(Reading& reading, std::string_view bus);

/// Ports for a bus of the kind that no <bus> of the robot names and whose line suits the devices on the bus `tag`.
std::vector<std::string> suitable_ports(Reading& reading, const xml::Node& tag, BusKind kind);

}  // namespace finemote::gen
