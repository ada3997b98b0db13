// Any device: a parent that asks for nothing but order and freshness.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// Role of every type. A child without a command gets a generated sink for the port's command.
struct Any {
  using State = Stamp;
  using Command = Stamp;
};

}  // namespace finemote
