// The worst case of the one stack all priority levels share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen {

/// Start-up and idle, one bucket, the release, or the bus interrupts of one level.
struct StackLevel {
  std::string name;               ///< `thread`, `release`, `bucket on line 48`, `bus interrupt on line 33`
  std::uint32_t bytes = 0;        ///< of its own functions
  std::uint32_t frame = 0;        ///< what the processor pushes when it interrupts the level below; 0 for the thread
  std::vector<std::string> path;  ///< the functions of the deepest call, entry first
};

struct StackBound {
  std::uint32_t bytes = 0;         ///< sum over all levels, each at its worst, interrupted at its worst
  std::vector<StackLevel> levels;  ///< least urgent first
  bool known = false;              ///< false: some path has no bound, see the diagnostics
};

/// Computes the bound from the linked code itself, so that library functions, tail calls and inlining are what they
/// are. Of each priority level one routine can be on the stack: every bucket, the release, and two levels of bus
/// interrupts. Indirect calls are allowed where the runtime calls through its tables (start-up, constructors, stop).
/// Reports FM6104 (recursion), FM6105 (an indirect call elsewhere), FM6106 (a function whose own use is unknown).
StackBound worst_case_stack(const Image& image, Diagnostics& diagnostics);

/// 26 words with the floating-point registers (PM0214 2.3.7), and one that aligns to 8 bytes.
inline constexpr std::uint32_t kExceptionFrame = 108;

}  // namespace finemote::gen
