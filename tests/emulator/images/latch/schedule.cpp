// Both latches and a naive copy, each between a slow side (the 1 ms bucket) and a fast side (line 48, more urgent),
// which the test makes pending wherever it likes. Every value is fourteen equal words; the image itself looks for
// mixtures.
#include <finemote/latch.hpp>
#include <finemote/schedule.hpp>

#include "runtime/chips/cortex_m4/core.hpp"

extern "C" {
enum : std::uint32_t { kToSlow, kToFast, kNaive };

/// Set by the test: which of the three is used.
volatile std::uint32_t latch_kind = kToSlow;
/// Read by the test.
volatile std::uint32_t mixtures = 0, steps_back = 0, stale = 0, slow_runs = 0, fast_runs = 0;

void finemote_line_48();
void finemote_line_49();
void slow_side();
}

namespace {

struct Value {
  std::uint32_t words[14];
};

finemote::LatchToSlow<Value> to_slow;
finemote::LatchToFast<Value> to_fast;
Value naive;

/// What finemote's single-slot copy would be: the naive latch that the test must catch.
void copy_naively(Value& to, const Value& from) {
  for (unsigned i = 0; i < 14; ++i)
    const_cast<volatile Value&>(to).words[i] = const_cast<const volatile Value&>(from).words[i];
}

Value make(std::uint32_t number) {
  Value value;
  for (std::uint32_t& word : value.words) word = number;
  return value;
}

/// Counts a mixture, or a value older than the one seen before.
void look_at(const Value& value, std::uint32_t& last) {
  for (const std::uint32_t word : value.words) {
    if (word != value.words[0]) {
      mixtures = mixtures + 1;
      return;
    }
  }
  if (value.words[0] < last) steps_back = steps_back + 1;
  last = value.words[0];
}

std::uint32_t written = 0, published = 0, last_read = 0;

void start_lines() { finemote::cortex_m4::enable_line(48, 4); }
void nothing() {}

}  // namespace

/// The interrupted side. One publish or one snapshot with the copy that follows it.
extern "C" __attribute__((noinline)) void slow_side() {
  if (latch_kind == kToSlow) {
    const std::uint32_t finished_before = published;
    const Value seen = to_slow.snapshot();
    look_at(seen, last_read);
    if (seen.words[0] < finished_before) stale = stale + 1;
  } else if (latch_kind == kToFast) {
    to_fast.publish(make(++written));
    published = written;
  } else {
    Value seen;
    copy_naively(seen, naive);
    look_at(seen, last_read);
  }
}

/// The interrupting side.
extern "C" void finemote_line_48() {
  fast_runs = fast_runs + 1;
  if (latch_kind == kToSlow) {
    to_slow.publish(make(++written));
    published = written;
  } else if (latch_kind == kToFast) {
    const std::uint32_t finished_before = published;
    const Value& seen = to_fast.snapshot();
    look_at(seen, last_read);
    if (seen.words[0] < finished_before) stale = stale + 1;
  } else {
    copy_naively(naive, make(++written));
  }
}

extern "C" void finemote_line_49() {
  slow_side();
  slow_runs = slow_runs + 1;
  finemote::complete(0);
}

namespace {
constexpr finemote::Bucket buckets[] = {{finemote_line_49, 1'000'000, 49, 5, 3}};
}

extern "C" const finemote::Schedule finemote_schedule{"latch",     1'000'000, buckets, finemote::Overrun::skip,
                                                      start_lines, nothing,   nullptr};
