// One end of a chain as people write it, in <require> and in --chain, to the names in it.
#pragma once

#include <string_view>

namespace finemote::gen {

/// `imu`, or `rover.wheels`: all children of a device in a role.
struct OperandText {
  std::string_view device;
  std::string_view role;  ///< empty and not `is_role`: the device itself
  bool is_role = false;
};

/// A device's own name may hold a dot: it goes before a role. `is_device` tells whether there is a device of a name.
template <typename IsDevice>
OperandText split_operand(std::string_view text, IsDevice is_device) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos || is_device(text)) return {text, {}, false};
  return {text.substr(0, dot), text.substr(dot + 1), true};
}

}  // namespace finemote::gen
