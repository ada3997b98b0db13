// Judges one I2C address.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Whether `address` is a 7-bit address a part of this type can have. Reports FM3061 for an 8-bit address (the 7-bit
/// one shifted left, as some data sheets print it) and FM3062 for any other that cannot be.
///
/// @param allowed  what the part can be set to; empty: everything outside the reserved ranges 0x00-0x07 and 0x78-0x7F.
bool check_address(Diagnostics& diagnostics, const xml::Attribute& attribute, std::uint32_t address,
                   const std::vector<std::uint32_t>& allowed, const std::string& type);

/// An address that is none, but would be without its read/write bit.
bool is_8bit_address(std::uint32_t address, const std::vector<std::uint32_t>& allowed);

}  // namespace finemote::gen
