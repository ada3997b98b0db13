// The header for the computer needs no other file of the project.
#include "host/pilot_link_link.hpp"

int main() {
  Linked::pilot_link_link::Frame frame;
  return Linked::pilot_link_link::make_frame({}, 0, 0, frame) == 0 ? 1 : 0;
}
