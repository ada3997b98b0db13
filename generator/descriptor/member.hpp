// Members of a JSON object that its schema accepts.
#pragma once

#include <optional>
#include <vector>

#include "generator/descriptor/json_file.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// None where the member is absent, or null (a merge patch removes with null).
template <typename T>
std::optional<T> optional_member(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return {};
  return found->get<T>();
}

/// A member that counts nanoseconds.
inline std::optional<Duration> duration_member(const Json& object, const char* key) {
  const auto ns = optional_member<std::int64_t>(object, key);
  return ns ? std::optional(nanoseconds(*ns)) : std::nullopt;
}

/// The entries of an array, each as `read` makes it; none where the member is absent or null.
template <typename T, typename Read>
std::vector<T> read_list(const Json& object, const char* key, Read read) {
  std::vector<T> list;
  const auto entries = object.find(key);
  if (entries == object.end() || entries->is_null()) return list;
  for (const Json& entry : *entries) list.push_back(read(entry));
  return list;
}

}  // namespace finemote::gen
