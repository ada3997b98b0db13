// How often a loop turns at most, where tools cannot see it from the code: docs/wcet.md.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/assembler.hpp"

namespace finemote {
namespace detail {

constexpr std::uint32_t kUnlessInterrupted = 0x8000'0000;
constexpr unsigned kRetriedByShift = 24;
/// Of a record of `.debug_finemote_mark_ids`: here the loop of these marks has not begun. Else: a mark of it.
constexpr std::uint32_t kBegins = 0x8000'0000;

/// A number of a line of a source file, below kBegins.
constexpr std::uint32_t place_in(const char* file, std::uint32_t line) {
  std::uint32_t hash = line;
  for (; *file != 0; ++file) hash = hash * 31U + static_cast<unsigned char>(*file);
  return hash & ~kBegins;
}

/// Records the address of this place and `word` in section `.debug_finemote_loops`, two words each.
template <std::uint32_t word>
[[gnu::always_inline]] inline void tell_loop() {
  FINEMOTE_OPTIMIZED_ASM("0:" FINEMOTE_FOR_TOOLS(".debug_finemote_loops", ".word 0b, %c0")::"i"(word));
}

}  // namespace detail

/// From when it is made on, which is right before a loop, `pass()` in the body of that loop is passed at most `passes`
/// times. Every round of the loop passes it. Both cost a `nop`: a place of their own. What is told must be true: bounds
/// are computed from it. `finemote run` counts the passes on the emulated board, of the inputs that it has; nothing
/// else checks it.
/// @code const LoopBound<kMostInboxes> inboxes;
///       for (Inbox* i = first; i != nullptr; i = i->next) { inboxes.pass(); ... } @endcode
template <std::uint32_t passes>
class LoopBound {
  static_assert(passes < 1U << detail::kRetriedByShift, "a loop that turns so often has no useful bound");

 public:
  [[gnu::always_inline]] explicit LoopBound(std::uint32_t place = detail::place_in(__builtin_FILE(), __builtin_LINE()))
      : place_(place) {
    FINEMOTE_OPTIMIZED_ASM(
        "0: nop" FINEMOTE_FOR_TOOLS(".debug_finemote_mark_ids", ".word 0b, %c0")::"i"(detail::kBegins | place));
  }
  LoopBound(const LoopBound&) = delete;
  LoopBound& operator=(const LoopBound&) = delete;

  [[gnu::always_inline]] void pass() const {
    FINEMOTE_OPTIMIZED_ASM("0: nop" FINEMOTE_FOR_TOOLS(".debug_finemote_loops", ".word 0b, %c0")
                               FINEMOTE_FOR_TOOLS(".debug_finemote_mark_ids", ".word 0b, %c1")::"i"(passes),
                           "i"(place_));
  }

 private:
  [[maybe_unused]] std::uint32_t place_;  // tells it apart from those of other loops
};

/// Keeps `left`, which a loop counts down, a number: compilers make a comparison of pointers of it, from which tools
/// read less. It costs no instruction.
/// @code for (; left != 0; --left) { as_counted(left); ... } @endcode
[[gnu::always_inline]] inline void as_counted([[maybe_unused]] std::size_t& left) {
  FINEMOTE_OPTIMIZED_ASM("" : "+r"(left));
}

/// Whose interrupts make a loop turn once more.
enum class RetriedBy : std::uint32_t {
  release,   ///< the release timer's
  received,  ///< those of frames that come in
  event,     ///< those of line events
  fault,     ///< those that count a fault
};

/// This place, in the body of a loop, is passed once from when the loop is entered to when it is left, and once more
/// for each interrupt of this kind that comes in between: it tries again what that has disturbed. Further rounds are
/// charged to these interrupts. What is told must be true: `finemote run` counts the passes, as those of a LoopBound.
template <RetriedBy by>
[[gnu::always_inline]] inline void retried_if_interrupted() {
  detail::tell_loop<detail::kUnlessInterrupted | static_cast<std::uint32_t>(by) << detail::kRetriedByShift | 1U>();
}

/// From when it is made on, which is before a loop, `pass()` in the body of that loop is passed in every round, but in
/// none that begins more than `cycles()` cycles later. Making it puts the number into a register; a pass costs a `nop`.
/// What is told must be true: bounds are computed from it, and nothing checks it.
/// @code const WaitBound wait(limit);
///       while (!is_ready() && cycles() - begin < limit) wait.pass(); @endcode
class WaitBound {
 public:
  [[gnu::always_inline]] explicit WaitBound(std::uint32_t cycles,
                                            std::uint32_t place = detail::place_in(__builtin_FILE(), __builtin_LINE()))
      : cycles_(cycles), place_(place) {
    [[maybe_unused]] std::uint32_t kept = cycles;  // for a member would have to lie in memory
    FINEMOTE_OPTIMIZED_ASM("0: mov %0, %1" FINEMOTE_FOR_TOOLS(".debug_finemote_mark_ids", ".word 0b, %c2")
                           : "=r"(kept)
                           : "rj"(cycles), "i"(detail::kBegins | place));
    cycles_ = kept;
  }
  WaitBound(const WaitBound&) = delete;
  WaitBound& operator=(const WaitBound&) = delete;

  [[nodiscard, gnu::always_inline]] std::uint32_t cycles() const { return cycles_; }

  [[gnu::always_inline]] void pass() const {
    FINEMOTE_OPTIMIZED_ASM(
        "0: nop" FINEMOTE_FOR_TOOLS(".debug_finemote_waits", ".word 0b\n\t.asciz \"%0\"\n\t.balign 8")
            FINEMOTE_FOR_TOOLS(".debug_finemote_mark_ids", ".word 0b, %c1")::"r"(cycles_),
        "i"(place_));
  }

 private:
  std::uint32_t cycles_;
  [[maybe_unused]] std::uint32_t place_;
};

}  // namespace finemote
