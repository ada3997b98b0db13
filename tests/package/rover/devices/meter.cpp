#include "meter.hpp"

namespace rover {

void Meter::update() {
  if (wheels_.size() > 0) ++jobs_;
}

}  // namespace rover
