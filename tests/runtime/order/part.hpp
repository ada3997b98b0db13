// A user's class that cannot be constant-initialised: its constructor has something to do.
#pragma once

#include <vector>

#include "finemote/order.hpp"

namespace order {

class Part {
 public:
  explicit Part(int weight) : weights_(1, weight) {}
  explicit Part(const Part& child) : weights_(1, child.total() + 1) {}
  [[nodiscard]] int total() const { return weights_.empty() ? -1000 : weights_.front(); }

 private:
  std::vector<int> weights_;  // not a constant expression in C++17
};

}  // namespace order
