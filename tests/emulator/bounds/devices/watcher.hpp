// Looks at the time over and over, and counts a fault when it goes back.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/fault.hpp"
#include "finemote/time.hpp"

namespace bounds {

class Watcher {
 public:
  void update() {
    for (unsigned turns = ++jobs_ % 97; turns != 0; --turns) state.valid = !state.valid;  // another phase in every job
    finemote::Time before = finemote::now();
    for (unsigned look = 0; look < 8000; ++look) {
      const finemote::Time at = finemote::now();
      if (at < before) finemote::count_fault(finemote::Module::order, 77);
      before = at;
    }
    state = {before, true};
  }
  void handle() {}

  finemote::Stamp state;

 private:
  unsigned jobs_ = 0;
};

}  // namespace bounds
