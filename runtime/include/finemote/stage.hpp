// Brackets one stage for the trace: nothing at all unless built with FINEMOTE_TRACE.
#pragma once

#include <cstdint>

#include "finemote/trace.hpp"

namespace finemote {

/// Lives as long as the stage runs. Number: 2 * device index in schedule order + (0 update, 1 handle).
class Stage {
 public:
#ifdef FINEMOTE_TRACE
  explicit Stage(std::uint16_t number) : code_(2U * number) { trace(code_); }
  ~Stage() { trace(code_ + 1U); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  std::uint32_t code_;
#else
  constexpr explicit Stage(std::uint16_t) {}
  ~Stage() {}  // user-provided, so that a stage's bracket is no unused variable
#endif
};

}  // namespace finemote
