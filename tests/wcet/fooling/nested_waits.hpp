// bounded: a wait in a wait: each try waits up to 200 cycles for an answer, and tries go on for 20,000
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
/// The cycle count of the core: DWT_CYCCNT.
inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }

struct Walker {
  void update() {
    const std::uint32_t begin = cycles();
    const finemote::WaitBound tries(20000);
    while (answer_ == 0 && cycles() - begin < 20000) {
      tries.pass();
      asked_ = asked_ + 1;
      const std::uint32_t sent = cycles();
      const finemote::WaitBound answer(200);
      while (answer_ == 0 && cycles() - sent < 200) answer.pass();
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t answer_ = 0, asked_ = 0;
};
}  // namespace my
