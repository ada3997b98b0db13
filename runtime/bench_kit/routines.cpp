#include "routines.hpp"

#include "bench_plan.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"

namespace finemote::bench_kit {
namespace {

using Routine = void (*)();

/// Core exceptions and lines: RM0090 12.2, table 62.
constexpr unsigned kFirstLine = 16, kVectors = kFirstLine + 82;

/// VTOR takes multiples of the table's size, rounded up to a power of two words: PM0214 4.4.4.
alignas(512) Routine vectors[kVectors];
Routine routines[kVectors];  ///< behind the stopwatch
std::uint16_t bus_of[kVectors];
std::uint32_t longest[kBusCount + 1];
std::uint32_t empty_routine = 0;

/// With nothing in between.
__attribute__((noinline)) std::uint32_t time_of(Routine routine) {
  asm volatile("cpsid i" ::: "memory");
  const std::uint32_t begin = cortex_m4::cycles();
  routine();
  const std::uint32_t took = cortex_m4::cycles() - begin;
  asm volatile("cpsie i" ::: "memory");
  return took;
}

void return_at_once() {}

void run_timed() {
  const std::uint32_t exception = cortex_m4::exception_number();
  const std::uint32_t took = time_of(routines[exception]);
  std::uint32_t& most = longest[bus_of[exception]];
  most = took > most ? took : most;
}

}  // namespace

void watch_routines() {
  namespace scb = cortex_m4::scb;
  empty_routine = time_of(return_at_once);
  const auto* const usual = reinterpret_cast<const Routine*>(scb::VectorTable::read());
  for (unsigned i = 0; i < kVectors; ++i) vectors[i] = usual[i];
  for (const BusLine& it : kBusLines) {
    if (it.line == kNoLine) break;
    const unsigned exception = kFirstLine + it.line;
    routines[exception] = usual[exception];
    bus_of[exception] = it.bus;
    vectors[exception] = run_timed;
  }
  const cortex_m4::Masked masked;
  scb::VectorTable::write(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(vectors)));
  cortex_m4::barrier();
}

std::uint32_t longest_routine(unsigned bus) { return longest[bus] > empty_routine ? longest[bus] - empty_routine : 0; }

}  // namespace finemote::bench_kit
