// How often a loop turns at most, where tools cannot see it from the code: docs/wcet.md.
#pragma once

#include <cstddef>
#include <cstdint>

namespace finemote {
namespace detail {

constexpr std::uint32_t kUnlessInterrupted = 0x8000'0000;
constexpr unsigned kRetriedByShift = 24;

/// Records the address of this place and `word` in section `.debug_finemote_loops`, two words each.
template <std::uint32_t word>
[[gnu::always_inline]] inline void tell_loop() {
#ifdef __arm__
  asm volatile inline(
      "0: .pushsection .debug_finemote_loops,\"\",%%progbits\n\t.word 0b, %c0\n\t.popsection" ::"i"(word));
#endif
}

}  // namespace detail

/// This place, in the body of a loop, is passed at most `passes` times from when the loop is entered to when it is
/// left. It costs no instruction. What is told must be true: bounds are computed from it. `finemote run` counts the
/// passes on the emulated board, of the inputs that it has; nothing else checks it.
/// Every round of the loop passes this place.
/// @code for (Inbox* i = first; i != nullptr; i = i->next) { loop_bound<kMostInboxes>(); ... } @endcode
template <std::uint32_t passes>
[[gnu::always_inline]] inline void loop_bound() {
  static_assert(passes < 1U << detail::kRetriedByShift, "a loop that turns so often has no useful bound");
  detail::tell_loop<passes>();
}

/// Keeps `left`, which a loop counts down, a number: compilers make a comparison of pointers of it, from which tools
/// read less. It costs no instruction.
/// @code for (; left != 0; --left) { as_counted(left); ... } @endcode
[[gnu::always_inline]] inline void as_counted([[maybe_unused]] std::size_t& left) {
#ifdef __arm__
  asm volatile inline("" : "+r"(left));
#endif
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
/// charged to these interrupts.
template <RetriedBy by>
[[gnu::always_inline]] inline void retried_if_interrupted() {
  detail::tell_loop<detail::kUnlessInterrupted | static_cast<std::uint32_t>(by) << detail::kRetriedByShift | 1U>();
}

/// This place is in the body of a loop that is left in the round after the cycle count has gone on by `cycles` from
/// when the loop was entered, or before. It puts the number into a register.
[[gnu::always_inline]] inline void leaves_after([[maybe_unused]] std::uint32_t cycles) {
#ifdef __arm__
  asm volatile inline(
      "0: .pushsection .debug_finemote_waits,\"\",%%progbits\n\t.word 0b\n\t.asciz \"%0\"\n\t.balign 8\n\t"
      ".popsection" ::"r"(cycles));
#endif
}

}  // namespace finemote
