#include "finemote/devices/sim_load.hpp"

#include "children.hpp"

namespace finemote {

namespace {

void work(Duration time) {
  if (time != 0) busy(time);
}

}  // namespace

void SimLoad::update() {
  const Stamp taken{now(), true};
  work(config_.update);
  state = children_.empty() ? taken : oldest_state(children_);
}

void SimLoad::handle() {
  work(config_.handle);
  command_all(children_, command.valid ? command : state);
}

}  // namespace finemote
