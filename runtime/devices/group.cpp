#include "finemote/devices/group.hpp"

#include "children.hpp"

namespace finemote {

void Group::update() { state = oldest_state(children_); }

void Group::handle() { command_all(children_, command.valid ? command : state); }

}  // namespace finemote
