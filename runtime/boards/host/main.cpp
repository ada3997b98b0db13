// The robot as a program on the host: runs for a duration of virtual time and prints what happened.
#include <cstdio>
#include <cstdlib>

#include "finemote/host.hpp"

#ifndef FINEMOTE_RUN_DURATION_NS
#define FINEMOTE_RUN_DURATION_NS 0
#endif

/// Usage: robot [duration in ns]. Exit status: 0 ran to the end, 1 stopped itself, 2 no duration.
int main(int argc, char** argv) {
  const finemote::Duration duration = argc > 1 ? std::atoll(argv[1]) : FINEMOTE_RUN_DURATION_NS;
  if (duration <= 0) {
    std::fprintf(stderr, "usage: %s DURATION_NS\n", argv[0]);
    return 2;
  }
  const bool ran = finemote::host::run(duration);
  finemote::host::print_run();
  if (!ran) std::fprintf(stderr, "stopped: %s\n", finemote::host::stop_text().c_str());
  return ran ? 0 : 1;
}
