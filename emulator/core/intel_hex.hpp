// Lines of Intel HEX to what lies where. Intel, Hexadecimal Object File Format Specification, revision A, 1988.
#pragma once

#include <string>
#include <vector>

#include "emulator/core/image.hpp"

namespace finemote::emulator {

/// Data that follow each other are one segment. Starting addresses are passed over: the chip takes its own.
/// @throws std::runtime_error naming the line that is wrong
std::vector<Segment> parse_intel_hex(const std::string& text);

}  // namespace finemote::emulator
