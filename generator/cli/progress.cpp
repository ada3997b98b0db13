#include "generator/cli/progress.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace finemote::gen {
namespace {

constexpr const char* kClear = "\r\033[K";

/// A terminal that can clear a line.
bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace

Progress::Progress(const Options& options) : is_shown_(!options.quiet && is_terminal()) {}

Progress::~Progress() {
  if (has_said_) std::cerr << kClear << std::flush;
}

void Progress::say(std::string_view what) {
  if (!is_shown_) return;
  std::cerr << kClear << what << std::flush;
  has_said_ = true;
}

}  // namespace finemote::gen
