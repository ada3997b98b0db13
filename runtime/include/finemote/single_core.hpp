// Turns a value shared between interrupt levels of one core into loads and stores the compiler may not move.
#pragma once

#include <atomic>

namespace finemote {

/// A word shared by code on different interrupt levels of one core. Every access is one load or store instruction and
/// is ordered against the accesses around it by the compiler alone: a single core sees its own memory in program order,
/// so no barrier instruction is needed. Read-modify-write members loop on LDREX/STREX (ARMv7-M Architecture Reference
/// Manual A3.4) and never mask interrupts. May be used from any context. Members are inlined even for size: the call of
/// one instruction would cost interrupt routines several times its own time.
template <class T>
class Shared {
 public:
  constexpr Shared() = default;
  constexpr explicit Shared(T value) : value_(value) {}

  [[gnu::always_inline]] T load() const {
    fence();
    T value = value_.load(std::memory_order_relaxed);
    fence();
    return value;
  }
  [[gnu::always_inline]] void store(T value) {
    fence();
    value_.store(value, std::memory_order_relaxed);
    fence();
  }
  [[gnu::always_inline]] T exchange(T value) {
    fence();
    T old = value_.exchange(value, std::memory_order_relaxed);
    fence();
    return old;
  }
  /// Stores `value` if the present one is `expected`; true if so.
  [[gnu::always_inline]] bool replace(T expected, T value) {
    fence();
    const bool replaced = value_.compare_exchange_strong(expected, value, std::memory_order_relaxed);
    fence();
    return replaced;
  }
  [[gnu::always_inline]] T set_bits(T bits) {
    fence();
    T old = value_.fetch_or(bits, std::memory_order_relaxed);
    fence();
    return old;
  }
  [[gnu::always_inline]] T clear_bits(T bits) {
    fence();
    T old = value_.fetch_and(static_cast<T>(~bits), std::memory_order_relaxed);
    fence();
    return old;
  }

  /// Keeps the compiler from moving memory accesses across this point.
  [[gnu::always_inline]] static void fence() { std::atomic_signal_fence(std::memory_order_seq_cst); }

 private:
  static_assert(std::atomic<T>::is_always_lock_free, "a shared value must be one machine word at most");
  std::atomic<T> value_{};
};

/// Lets every store leave the core before the interrupt routine that made it returns: one that still waits for the bus
/// may make the core vector to the wrong routine (Arm erratum 838869, Cortex-M4), and a release would be lost. The last
/// thing of such a routine.
[[gnu::always_inline]] inline void drain_stores() {
#ifdef __arm__
  asm volatile("dsb" : : : "memory");
#endif
}

}  // namespace finemote
