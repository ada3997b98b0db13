// A device that works for a stated time: the least a robot needs to show its schedule.
#pragma once

#include "finemote/constinit.hpp"
#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace sample {

class Load {
 public:
  constexpr Load(finemote::Duration update, finemote::Duration handle, finemote::Ports<finemote::Any> children = {})
      : update_(update), handle_(handle), children_(children) {}

  finemote::Stamp state;
  finemote::Stamp command;

  void update() {
    const finemote::Time begin = finemote::now();
    finemote::busy(update_);
    finemote::Time origin = begin;
    for (const auto& child : children_) origin = finemote::oldest(origin, child.state.origin);
    state.origin = origin;
    state.valid = true;
  }
  void handle() {
    finemote::busy(handle_);
    for (const auto& child : children_) child.command = state;
  }

 private:
  finemote::Duration update_;
  finemote::Duration handle_;
  finemote::Ports<finemote::Any> children_;
};

}  // namespace sample
