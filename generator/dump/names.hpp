// Devices and segments of a robot by their names.
#pragma once

#include <optional>

#include "generator/dump/dump.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

inline Json device_name(const Robot& robot, DeviceId device) { return robot.devices[device].name.text; }

inline Json segment_name(const Robot& robot, SegmentId segment) { return robot.segments[segment].name.text; }

/// @tparam Devices  a range of DeviceId
template <typename Devices>
Json device_names(const Robot& robot, const Devices& devices) {
  Json names = Json::array();
  for (const DeviceId device : devices) names.push_back(device_name(robot, device));
  return names;
}

/// Null for none.
template <typename Type>
Json value_or_null(const std::optional<Type>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Nanoseconds; null for none.
inline Json value_or_null(std::optional<Duration> time) { return time ? Json(time->ns()) : Json(nullptr); }

/// Null for an empty text.
inline Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

}  // namespace finemote::gen
