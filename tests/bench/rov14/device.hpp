// Devices without work of their own: what remains of a run is what the runtime costs.
#pragma once

#include "finemote/constinit.hpp"
#include "finemote/contract.hpp"
#include "finemote/interfaces/imu.hpp"

namespace bench {

/// One instruction per stage: the return.
class Empty {
 public:
  constexpr explicit Empty(unsigned index) : index_(index) {}
  finemote::ImuState state;
  __attribute__((noinline)) void update();
  __attribute__((noinline)) void handle();

 private:
  unsigned index_;
};

}  // namespace bench
