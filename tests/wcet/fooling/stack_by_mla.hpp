// refused: an element of an array on the stack, whose address is made by a multiplication
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    Job jobs[4];
    for (Job& job : jobs) {
      job.rounds = 1;
      job.other = 3;
    }
    const std::uint32_t k = k_ & 3;
    jobs[k].rounds = 40;
    k_ = k_ + 1;
    work(jobs);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Job {
    std::uint32_t rounds;
    std::uint32_t other;
    std::uint8_t data[20];
  };
  [[gnu::noipa]] void work(const Job* jobs) {
    for (std::uint32_t i = 0; i < jobs[2].rounds; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t x_ = 3, k_ = 0;
};
}  // namespace my
