// Turns the states of all children into one stamp, and one stamp into the commands of all.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace finemote {

/// The origin of the oldest; valid when every one is. No children: invalid.
inline Stamp oldest_state(const Ports<Any>& children) {
  if (children.empty()) return {};
  Stamp all{children[0].state.origin, true};
  for (const Port<Any>& child : children) {
    all.origin = oldest(all.origin, child.state.origin);
    all.valid = all.valid && child.state.valid;
  }
  return all;
}

inline void command_all(const Ports<Any>& children, const Stamp& command) {
  for (const Port<Any>& child : children) child.command = command;
}

}  // namespace finemote
