// The host as a board: no clocks, no watchdog; text goes to stderr.
#include "finemote/board.hpp"

#include <cstdio>

namespace finemote::board {

void start_hardware() {}
bool restarted_unasked() { return false; }
void start_watchdog(Duration) {}
void feed_watchdog() {}
void say(const char* text) {
  if (text != nullptr) std::fputs(text, stderr);
}
void stopped() {}

}  // namespace finemote::board
