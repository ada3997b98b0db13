#include "generator/model/address.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/model/attributes.hpp"

namespace finemote::gen {
namespace {

bool is_possible(std::uint32_t address, const std::vector<std::uint32_t>& allowed) {
  if (!allowed.empty()) return std::find(allowed.begin(), allowed.end(), address) != allowed.end();
  return address >= 0x08 && address <= 0x77;  // the rest is reserved (UM10204 3.1.12)
}

std::string list(const std::vector<std::uint32_t>& addresses) {
  std::string text;
  for (const std::uint32_t address : addresses) text += fmt::format("{}0x{:02x}", text.empty() ? "" : ", ", address);
  return text;
}

}  // namespace

bool is_8bit_address(std::uint32_t address, const std::vector<std::uint32_t>& allowed) {
  return address <= 0xFF && is_possible(address >> 1, allowed) && (address > 0x77 || !allowed.empty());
}

bool check_address(Diagnostics& diagnostics, const xml::Attribute& attribute, std::uint32_t address,
                   const std::vector<std::uint32_t>& allowed, const std::string& type) {
  if (is_possible(address, allowed)) return true;
  if (is_8bit_address(address, allowed)) {
    at_value(diagnostics, code::address_8bit, attribute,
             fmt::format("0x{:02x} is an 8-bit address, with the read/write bit", address))
        .hint(fmt::format("write the 7-bit address: address=\"0x{:02x}\"", address >> 1));
    return false;
  }
  auto& finding = at_value(diagnostics, code::address_range, attribute,
                           fmt::format("'{}' cannot have the address 0x{:02x}", type, address));
  finding.hint(allowed.empty() ? "write a 7-bit address from 0x08 to 0x77"
                               : fmt::format("it can have {}", list(allowed)));
  return false;
}

}  // namespace finemote::gen
