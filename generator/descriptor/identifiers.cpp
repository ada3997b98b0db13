#include "generator/descriptor/identifiers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

Identifiers read_entry(const Json& entry) {
  Identifiers identifiers;
  identifiers.base = entry.at("base").get<std::uint32_t>();
  identifiers.per_id = entry.value("per_id", identifiers.per_id);
  identifiers.count = entry.value("count", identifiers.count);
  return identifiers;
}

}  // namespace

std::optional<std::uint64_t> common_identifier(const IdentifierRange& a, const IdentifierRange& b) {
  const std::uint64_t first = std::max(a.first, b.first);
  if (first > std::min(a.last(), b.last())) return {};
  return first;
}

std::vector<Identifiers> read_identifiers(const Json& value) {
  if (value.is_object()) return {read_entry(value)};
  std::vector<Identifiers> list;
  for (const Json& entry : value) list.push_back(read_entry(entry));
  return list;
}

}  // namespace finemote::gen
