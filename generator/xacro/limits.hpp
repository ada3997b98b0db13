// The bounds of a document: generous for robots, and reached within a second by an input that never ends.
#pragma once

#include <cstddef>

#include "generator/xacro/engine.hpp"

namespace finemote::gen::xacro {

inline constexpr std::size_t kMaxCalls = 300'000;                  ///< macro calls of one expansion
inline constexpr std::size_t kMaxParameters = 1 << 20;             ///< bytes of the parameters of one macro
inline constexpr std::size_t kMaxNestedCalls = 2'000;              ///< macro calls inside macro calls
inline constexpr std::size_t kMaxOutput = std::size_t{512} << 20;  ///< bytes of names, values and texts of the result
inline constexpr std::size_t kMaxOutputDepth = 2'000;              ///< elements inside elements of the result
inline constexpr std::size_t kMaxIncludes = 200;                   ///< files inside files
inline constexpr std::size_t kMaxFolders = 10'000;                 ///< folders listed for wild cards

/// One level deeper, or a failure at the tag that asks for it.
[[nodiscard]] inline Level enter(std::size_t& depth, std::size_t limit, const char* message, const Position& at) {
  if (depth >= limit) throw Failure{code::xacro_limit, message, at};
  return Level(depth, limit, message);
}

}  // namespace finemote::gen::xacro
