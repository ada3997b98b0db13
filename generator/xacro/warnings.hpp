// The warnings of an expansion: one per place and text, however often the place is passed.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen::xacro {

class Warnings {
 public:
  explicit Warnings(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// The new finding, or null when it was given before or there are too many.
  Diagnostic* add(Code code, const Position& at, const std::string& message) {
    constexpr std::size_t most = 1000;
    if (given_.size() >= most || !given_.emplace(at.file, at.line, at.column, message).second) return nullptr;
    return &diagnostics_.warning(code, at, message);
  }

 private:
  Diagnostics& diagnostics_;
  std::set<std::tuple<const SourceFile*, std::uint32_t, std::uint32_t, std::string>> given_;
};

}  // namespace finemote::gen::xacro
