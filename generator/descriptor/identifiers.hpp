// Which identifiers the frames of a part on CAN have: `receives` of a device descriptor.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace finemote::gen {

/// Identifiers in a row.
struct IdentifierRange {
  std::uint64_t first = 0, count = 1;

  [[nodiscard]] std::uint64_t last() const { return first + count - 1; }
};

/// The lowest identifier that two ranges have in common; none: they have none.
std::optional<std::uint64_t> common_identifier(const IdentifierRange& a, const IdentifierRange& b);

/// An entry: `base + per_id * id` and what follows it, `count` in all.
struct Identifiers {
  std::uint32_t base = 0;
  std::uint32_t per_id = 1;  ///< 0: the same whatever the id
  std::uint32_t count = 1;   ///< a power of two; base and per_id are multiples of it

  [[nodiscard]] IdentifierRange of(std::uint32_t id) const { return {base + std::uint64_t{per_id} * id, count}; }
};

/// The highest id of a device on a bus: slots keep 16 bits.
inline constexpr std::uint32_t kHighestId = 0xFFFF;

/// The highest identifier: eleven bits.
inline constexpr std::uint64_t kHighestIdentifier = 0x7FF;

/// Reads a member that the schema accepts: an entry, or a list of them.
std::vector<Identifiers> read_identifiers(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
