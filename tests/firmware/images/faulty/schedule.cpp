// A robot that runs well for a while and then fails in one way, chosen by a definition.
#include <cstdint>

#include <finemote/schedule.hpp>
#include <finemote/time.hpp>

extern "C" void finemote_line_48();

namespace {

volatile int jobs;
volatile int safe_calls;

#if defined(FAULTY_STACK)
__attribute__((noinline)) int deeper(int n) {
  volatile int bytes[16] = {n};
  return n == 0 ? bytes[0] : deeper(n + 1) + bytes[0];
}
void fail() { jobs = deeper(1); }
#elif defined(FAULTY_LINE)
void fail() {  // enables and pends line 77
  *reinterpret_cast<volatile std::uint32_t*>(0xE000E108) = 1U << 13;
  *reinterpret_cast<volatile std::uint32_t*>(0xE000E208) = 1U << 13;
}
#elif defined(FAULTY_USAGE)
void fail() { asm volatile("udf #0"); }
#elif defined(FAULTY_BUS)
void fail() { jobs = *reinterpret_cast<volatile int*>(0xA0000000); }
#elif defined(FAULTY_OVERRUN)
void fail() { finemote::busy(7 * finemote::kMillisecond); }
#endif

void nothing() {}
void safe() { safe_calls = safe_calls + 1; }

constexpr finemote::Bucket buckets[] = {{finemote_line_48, 5'000'000, 48, 4, 3}};

}  // namespace

extern "C" void finemote_line_48() {
  jobs = jobs + 1;
  if (jobs == 4) fail();
}
extern "C" const finemote::Schedule finemote_schedule{
    "Faulty", 1'000'000, buckets, finemote::Overrun::safe_stop, nothing, safe, nullptr};
