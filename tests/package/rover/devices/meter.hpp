// Counts the jobs of the rover, in a source file of its own.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace rover {

class Meter {
 public:
  constexpr explicit Meter(finemote::Ports<finemote::Any> wheels) : wheels_(wheels) {}

  void update();
  void handle() {}

  [[nodiscard]] unsigned jobs() const { return jobs_; }

 private:
  finemote::Ports<finemote::Any> wheels_;
  unsigned jobs_ = 0;
};

}  // namespace rover
