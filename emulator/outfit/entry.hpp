// Members of a scenario's entries, with errors that show the entry.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "emulator/time.hpp"

namespace finemote::emulator {

using Json = nlohmann::ordered_json;

[[noreturn]] inline void refuse(const Json& entry, const std::string& why) {
  throw std::invalid_argument(why + ": " + entry.dump());
}

/// The member, which has to be there. @throws std::invalid_argument otherwise, or when it has another type
template <class T>
T need(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end()) refuse(entry, std::string("'") + key + "' is missing");
  try {
    return found->get<T>();
  } catch (const nlohmann::json::exception&) {
    refuse(entry, std::string("'") + key + "' has the wrong type");
  }
}

/// The member, or `fallback` where there is none.
template <class T>
T maybe(const Json& entry, const char* key, T fallback) {
  return entry.contains(key) ? need<T>(entry, key) : fallback;
}

inline Eigen::Vector3d vector(const Json& entry, const char* key,
                              const Eigen::Vector3d& fallback = Eigen::Vector3d::Zero()) {
  if (!entry.contains(key)) return fallback;
  const auto list = need<std::vector<double>>(entry, key);
  if (list.size() != 3) refuse(entry, std::string("'") + key + "' has three numbers");
  return {list[0], list[1], list[2]};
}

/// Between two frames of a part that speaks by itself, on the board's clock.
inline Time period_of(const Json& entry) {
  const auto own = static_cast<double>(from_ns(need<std::uint64_t>(entry, "period_ns")));
  return static_cast<Time>(own / (1 + need<double>(entry, "clock_ppm") * 1e-6) + 0.5);
}
/// Of its first frame.
inline Time phase_of(const Json& entry) { return from_ns(maybe<std::uint64_t>(entry, "phase_ns", 0)); }

/// Of a fault that lasts: it begins, and does not end.
inline bool is_on(const Json& event) { return maybe(event, "on", true); }

}  // namespace finemote::emulator
