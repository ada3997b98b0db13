// The rate of a <bus> to a number that its port makes. FM3010, FM3017, FM3018 and the codes of quantities.
#pragma once

#include "generator/model/reading.hpp"

namespace finemote::gen {

/// Reads the rate of a bus whose kind and port are known, the port as far as there is one.
void read_rate(Reading& reading, const xml::Node& tag, Bus& bus, Reading::BusState& state);

}  // namespace finemote::gen
