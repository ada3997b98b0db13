// What a long command does right now, to one line that a terminal shows and that is gone when the command ends.
#pragma once

#include <string_view>

#include "generator/cli/options.hpp"

namespace finemote::gen {

/// Writes to standard error, and only where that is a terminal and -q is not given.
class Progress {
 public:
  explicit Progress(const Options& options);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Replaces what was said before; one line, without its end.
  void say(std::string_view what);

 private:
  bool is_shown_;
  bool has_said_ = false;
};

}  // namespace finemote::gen
