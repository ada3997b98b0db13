// The raw record of a run: everything that its figures are made of, event by event.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// Watches a board from its creation on, which keeps its log.
class Audit {
 public:
  /// @param image    loaded on the board; both outlive this
  /// @param buckets  the exception of every bucket, in the order of their overrun counters
  Audit(Board& board, const Image& image, std::vector<std::uint32_t> buckets);
  Audit(const Audit&) = delete;
  Audit& operator=(const Audit&) = delete;
  ~Audit();

  /// `[ps since zero, what, number]` in the order of time: `enter` `tail` `return` `resume` `due` and `overrun` with an
  /// exception, `begin` and `end` with a stage, `mask` `unmask` `reset` with 0.
  /// @param zero_ns  since power-on
  [[nodiscard]] nlohmann::ordered_json events(std::int64_t zero_ns) const;

 private:
  struct Overrun {
    Time at;
    std::uint32_t exception;
  };
  void look_for_overruns();

  Board& board_;
  const Image& image_;
  std::vector<std::uint32_t> buckets_, counted_;
  std::vector<Overrun> overruns_;
};

}  // namespace finemote::emulator
