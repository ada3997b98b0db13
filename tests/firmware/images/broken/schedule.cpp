// A robot that breaks one promise of the target code, chosen by a definition.
#include <finemote/schedule.hpp>

#ifdef BROKEN_HEAP
#include <new>
#endif

extern "C" void finemote_line_48();

namespace {

volatile int input = 3;
volatile int output;

#if defined(BROKEN_HEAP)
void job() {
  int* value = new int(input);
  output = *value;
  delete value;
}
#elif defined(BROKEN_RECURSION)
__attribute__((noinline)) int even(int n);
__attribute__((noinline)) int odd(int n) { return n == 0 ? output : even(n - 1) + 1; }
__attribute__((noinline)) int even(int n) { return n == 0 ? input : odd(n - 1) + 2; }
void job() { output = even(input); }
#elif defined(BROKEN_POINTER)
int twice(int n) { return 2 * n; }
int (*volatile pointer)(int) = twice;
void job() { output = pointer(input); }
#elif defined(BROKEN_ARRAY)
void job() {
  volatile char* bytes = static_cast<volatile char*>(__builtin_alloca(static_cast<unsigned>(input)));
  for (int i = 0; i < input; ++i) bytes[i] = 1;
  output = bytes[0];
}
#elif defined(BROKEN_CONSTRUCTOR)
struct Early {
  Early() : value(input) {}
  int value;
};
Early early;
void job() { output = early.value; }
#elif defined(BROKEN_STACK)
void job() {
  volatile char bytes[5000];
  for (int i = 0; i < 5000; ++i) bytes[i] = static_cast<char>(input);
  output = bytes[4999];
}
#else
#error "say what is broken"
#endif

void nothing() {}
constexpr finemote::Bucket buckets[] = {{finemote_line_48, 5'000'000, 48, 4, 3}};

}  // namespace

extern "C" void finemote_line_48() { job(); }
extern "C" const finemote::Schedule finemote_schedule{
    "Broken", 1'000'000, buckets, finemote::Overrun::skip, nothing, nothing, nullptr};
