// What a file says that its schema takes and that cannot be so: FM3103, at the value at fault.
#pragma once

#include <string>
#include <utility>

#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

class Contradictions {
 public:
  Contradictions(Origin origin, Diagnostics& diagnostics) : origin_(std::move(origin)), diagnostics_(diagnostics) {}

  /// Reports `message` at the value at `path`, or at its nearest ancestor that exists: in the nearest text that says
  /// something of it, for that is what fits no longer.
  Diagnostic& add(const JsonPath& path, std::string message) const {
    const Extent extent = find_value(speaker(path), path);
    return diagnostics_.error(code::descriptor_contradiction, extent.at, std::move(message)).underline(extent.length);
  }
  /// Whether there is a value at `path`.
  [[nodiscard]] bool has(const JsonPath& path) const { return holds_value(origin_, path); }
  /// Of two values that do not fit each other the one that the nearest text says; `first` where one text says both.
  [[nodiscard]] JsonPath nearest(const JsonPath& first, const JsonPath& second) const {
    for (const SourceFile* layer : origin_.layers()) {
      if (holds_value(*layer, first)) return first;
      if (holds_value(*layer, second)) return second;
    }
    return first;
  }

 private:
  [[nodiscard]] const SourceFile& speaker(const JsonPath& path) const {
    for (const SourceFile* layer : origin_.layers()) {
      if (!path.empty() && holds_value(*layer, {path.front()})) return *layer;
    }
    return *origin_.layers().front();
  }

  Origin origin_;
  Diagnostics& diagnostics_;
};

}  // namespace finemote::gen
