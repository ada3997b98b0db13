// Places that the sources mark for tools: brackets of stages and of the runtime's work, and bounds of loops.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen::wcet {

/// Whose interrupts make a loop run one more iteration, by the numbers of runtime/include/finemote/loop_bound.hpp.
enum class RetriedBy : std::uint32_t { release, received, event, fault };
inline constexpr std::size_t kKindsOfRetry = 4;

/// Brackets from here on are the runtime's own work, those below it stages: runtime/include/finemote/mark.hpp.
inline constexpr std::uint32_t kFirstWorkMark = 0x40000;
/// The begin mark of Work::masked there.
inline constexpr std::uint32_t kMaskedMark = kFirstWorkMark + 2 * 7;

/// What the second words of records are made of.
namespace records {
// runtime/include/finemote/loop_bound.hpp
inline constexpr std::uint32_t kUnlessInterrupted = 0x8000'0000;
inline constexpr unsigned kRetriedByShift = 24;
inline constexpr std::uint32_t kBegins = 0x8000'0000;
// runtime/include/finemote/raised_by.hpp
inline constexpr std::uint32_t kOnceForEach = 0x8000'0000;
}  // namespace records

struct Marks {
  /// By address: numbers of runtime/include/finemote/mark.hpp.
  std::multimap<std::uint32_t, std::uint32_t> brackets;
  /// By address: how often the place is passed at most in the innermost loop around it, per entry of the loop.
  std::map<std::uint32_t, std::uint32_t> loop_bounds;
  /// By address of a mark of a loop or of a wait: the id that its begin marks have, too. A mark without one, or with
  /// several, belongs to an unknown loop.
  std::map<std::uint32_t, std::set<std::uint32_t>> ids;
  /// By address: whose loop has not begun yet, and does so after it.
  std::multimap<std::uint32_t, std::uint32_t> begins;

  /// By the start of a block in a loop that is gone through once more after some interrupts: which.
  std::map<std::uint32_t, RetriedBy> retries;

  /// By address in a loop: the register that holds how many cycles it waits at most.
  std::map<std::uint32_t, int> waits;

  /// Starts of blocks that are reached only after a fault.
  std::set<std::uint32_t> faults;

  /// By the start of a block that only some interrupts of a bus lead to: their Causes.
  std::map<std::uint32_t, std::uint32_t> raised;

  /// By the start of a block in a loop that is passed once for each interrupt of a cause, whichever run passes it: that
  /// one.
  std::map<std::uint32_t, std::uint32_t> once_for_each;

  /// All of them, in order.
  [[nodiscard]] std::vector<std::uint32_t> addresses() const;
};

/// Of sections `.debug_finemote`, and `_loops`, `_mark_ids`, `_waits`, `_faults` and `_raised` after that name. Records
/// of code that the linker left out are none.
Marks read_marks(const Image& image);

}  // namespace finemote::gen::wcet
