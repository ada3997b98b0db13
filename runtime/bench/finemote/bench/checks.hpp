// Counts what a test program found, for tests without a framework: each check that fails says where, and what it saw.
#pragma once

#include <cstdio>
#include <sstream>

namespace finemote::bench {

/// The checks of one program. `main` returns status().
class Checks {
 public:
  /// It holds.
  /// @param what  the statement that should hold, in words
  void that(bool holds, const char* what, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    note(holds, what, "it does not hold", file, line);
  }

  /// The two are the same.
  template <class A, class B>
  void equal(const A& seen, const B& expected, const char* what, const char* file = __builtin_FILE(),
             int line = __builtin_LINE()) {
    std::ostringstream text;
    text << "saw " << +seen << ", expected " << +expected;
    note(seen == expected, what, text.str().c_str(), file, line);
  }

  /// The two differ by at most `tolerance`; a number that is none is near nothing.
  void near(double seen, double expected, double tolerance, const char* what, const char* file = __builtin_FILE(),
            int line = __builtin_LINE()) {
    std::ostringstream text;
    text << "saw " << seen << ", expected " << expected << " within " << tolerance;
    const double difference = seen < expected ? expected - seen : seen - expected;
    note(difference <= tolerance, what, text.str().c_str(), file, line);
  }

  /// Prints the sum. 0: at least one check, and all hold; 1 otherwise.
  [[nodiscard]] int status() const {
    std::printf("%d checks, %d failed\n", checks_, failed_);
    return failed_ == 0 && checks_ > 0 ? 0 : 1;
  }

 private:
  void note(bool holds, const char* what, const char* how, const char* file, int line) {
    ++checks_;
    if (holds) return;
    ++failed_;
    std::printf("%s:%d: error: %s: %s\n", file, line, what, how);
  }

  int checks_ = 0, failed_ = 0;
};

}  // namespace finemote::bench
