// Devices and segments of a robot by their names.
#pragma once

#include <optional>

#include "generator/dump/dump.hpp"

namespace finemote::gen {

template <typename Index>
Json device_name(const Robot& robot, Index device) {
  return robot.devices[device].name.text;
}

template <typename Index>
Json segment_name(const Robot& robot, Index segment) {
  return robot.segments[segment].name.text;
}

template <typename List>
Json device_names(const Robot& robot, const List& devices) {
  Json names = Json::array();
  for (const auto device : devices) names.push_back(device_name(robot, device));
  return names;
}

/// Null for none.
template <typename Type>
Json value_or_null(const std::optional<Type>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Null for an empty text.
inline Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

}  // namespace finemote::gen
