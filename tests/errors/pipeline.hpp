// A robot's text through everything `generate` does before it writes: for tests that do it thousands of times.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/library.hpp"
#include "generator/emit/render.hpp"

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
  std::string said;               ///< all messages, as text
  std::vector<OutputFile> files;  ///< generated, unschedulable: what --allow-unschedulable would write
  std::string space;              ///< C++ name of the robot
};

/// The types and boards are read once. Throws what the tool would end with exit status 3 for.
class Pipeline {
 public:
  /// `folder` is where `devices/` is looked for; `device_paths` are further folders of descriptors.
  explicit Pipeline(const std::string& folder, std::vector<std::string> device_paths = {});

  /// Null when there is no such type.
  const DeviceType* device_type(std::string_view name);

  /// xacro (when asked for), model, forest, schedule, timing, lint, emit.
  Outcome run(const std::string& text, bool is_xacro = false);

 private:
  Sources library_sources_;
  Diagnostics library_diagnostics_;
  std::optional<Library> library_;
};

}  // namespace finemote::gen
