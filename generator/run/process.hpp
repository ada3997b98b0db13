// Runs another program to its end, under a time limit.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

struct ProcessResult {
  int exit_status = 0;     ///< 128 + signal when it was killed
  bool started = false;    ///< false: no such program
  bool timed_out = false;  ///< killed because the time was over
  std::string output;      ///< stdout and stderr in the order written
};

/// Thrown where this process was told to stop (SIGINT, SIGTERM, SIGHUP) while another program ran, which has been
/// killed. No std::exception: nothing but main() is to take it for handled.
struct StopRequested {
  int signal;
};

/// Looks `command[0]` up in PATH, gives it no input, and waits at most `limit`; then the whole process group is killed.
/// Of `environment`, NAME=value is set beside the inherited ones, and NAME alone is removed. Output beyond 256 MiB is
/// dropped. Throws StopRequested.
ProcessResult run_process(const std::vector<std::string>& command, std::chrono::seconds limit,
                          const std::vector<std::string>& environment = {});

/// FM0006, where a program was not started.
void report_not_started(const std::string& program, const std::string& hint, Diagnostics& diagnostics);

}  // namespace finemote::gen
