// A robot's text through everything `generate` does before it writes: for tests that do it thousands of times.
#pragma once

#include <optional>
#include <string>

#include "generator/descriptor/library.hpp"

namespace finemote::gen {

/// What became of one input.
struct Outcome {
  enum class Kind {
    generated,      ///< exit 0: there are files
    unschedulable,  ///< exit 1: a robot, and the answer is no
    refused,        ///< exit 2: no robot
    unexplained,    ///< refused without a message, or a message that does not say where
  };
  Kind kind = Kind::unexplained;
  std::string said;  ///< all messages, as text
};

/// The types and boards are read once. Throws what the tool would end with exit status 3 for.
class Pipeline {
 public:
  /// `folder` is where `devices/` is looked for.
  explicit Pipeline(const std::string& folder);

  /// xacro (when asked for), model, forest, schedule, timing, lint, emit.
  Outcome run(const std::string& text, bool is_xacro = false);

 private:
  Sources library_sources_;
  Diagnostics library_diagnostics_;
  std::optional<Library> library_;
};

}  // namespace finemote::gen
