// What the self-test has found out so far. It outlives the reset that ends a test which hangs or faults: the tests
// behind that one still run, and the record is always printed.
#pragma once

#include <cstdint>

#include "bench_plan.hpp"  // made of the board file for every kit: the tests and what is expected of them

namespace finemote::bench_kit {

/// Why a test has no value.
enum class Missing : std::uint8_t {
  not_run,  ///< not come to yet
  nothing,  ///< it has a value
  partner,  ///< nothing came from what it needs beside the board
  answer,   ///< what it asks or waits for did not come in time
  clock,    ///< the board's clock does not run
  restart,  ///< the board was reset in the middle of it
};

void put(Test test, std::uint32_t value);
/// The larger of what it has and `value`.
void put_largest(Test test, std::uint32_t value);
void miss(Test test, Missing why);

struct Entry {
  std::uint32_t value;
  Missing missing;
};
[[nodiscard]] const Entry& entry(unsigned test);

/// The group of tests to begin with: 0, or the one behind that in which the board was reset, by whomever: what resets
/// the board in every run, as a supply that breaks down under a test does, must not keep the record from its end.
unsigned begin_record();
/// From here on a reset belongs to this group.
void enter_group(Group group);
/// Everything was run: the next reset begins anew.
void end_record();

}  // namespace finemote::bench_kit
