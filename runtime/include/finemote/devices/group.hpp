// Turns several devices into one: the oldest state goes up, the command goes down to each.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace finemote {

/// Valid when every member is; as old as the oldest.
class Group {
 public:
  constexpr explicit Group(Ports<Any> children) : children_(children) {}

  void update();
  /// As a root it has no command, and its members get its state: how fresh the group is.
  void handle();

  Stamp state;
  Stamp command;

 private:
  const Ports<Any> children_;
};

}  // namespace finemote
