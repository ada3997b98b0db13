#include "finemote/devices/sim_load.hpp"

#include "children.hpp"

namespace finemote {

void SimLoad::update() {
  const Stamp taken{now(), true};
  busy(config_.update);
  state = children_.empty() ? taken : oldest_state(children_);
}

void SimLoad::handle() {
  busy(config_.handle);
  command_all(children_, command.valid ? command : state);
}

}  // namespace finemote
