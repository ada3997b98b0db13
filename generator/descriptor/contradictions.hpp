// What a file says that its schema takes and that cannot be so: FM3103, at the value at fault.
#pragma once

#include <string>

#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

class Contradictions {
 public:
  Contradictions(const SourceFile& source, Diagnostics& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  /// Reports `message` at the value at `path`, or at its nearest ancestor that exists.
  void add(const JsonPath& path, std::string message) const {
    const Extent extent = find_value(source_, path);
    diagnostics_.error(code::descriptor_contradiction, extent.at, std::move(message)).underline(extent.length);
  }
  /// Whether the file has a value at `path`.
  [[nodiscard]] bool has(const JsonPath& path) const { return holds_value(source_, path); }

 private:
  const SourceFile& source_;
  Diagnostics& diagnostics_;
};

}  // namespace finemote::gen
