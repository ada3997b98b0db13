// bounded: so many waits that notes on them would lie where the code does, if they were a part of it
#pragma once

#include <cstdint>
#include <utility>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

template <std::uint32_t count>
struct Waits {
  void update() { all(std::make_integer_sequence<std::uint32_t, count>{}); }
  void handle() {}
  finemote::Stamp state;

 private:
  static std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }
  template <std::uint32_t n>
  [[gnu::noinline]] void wait_one() {
    const std::uint32_t begin = cycles();
    const finemote::WaitBound wait(n + 10);
    while (x_ == 0 && cycles() - begin < n + 10) wait.pass();
  }
  template <std::uint32_t... n>
  [[gnu::always_inline]] void all(std::integer_sequence<std::uint32_t, n...> /*all*/) {
    (wait_one<n>(), ...);
  }
  volatile std::uint32_t x_ = 3;
};

struct Walker : Waits<60> {};
struct Urgent : Waits<2> {};

}  // namespace my
