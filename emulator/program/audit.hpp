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
  /// @param works    marks that are no stages', by half their numbers: told as well, each time they are passed
  Audit(Board& board, const Image& image, std::vector<std::uint32_t> buckets, std::vector<std::uint32_t> works);
  Audit(const Audit&) = delete;
  Audit& operator=(const Audit&) = delete;
  ~Audit();

  /// `events`: three numbers for each, in the order of time: ps since zero, what of `names`, number. What is `enter`
  /// `tail` `return` `resume` `due` and `overrun` with an exception, `begin` and `end` with a stage, `work` and `done`
  /// with one of the works, `mask` `unmask` `reset` with 0. In one list, as there are tens of thousands.
  /// @param zero_ns  since power-on
  [[nodiscard]] nlohmann::ordered_json events(std::int64_t zero_ns) const;

 private:
  struct Overrun {
    Time at;
    std::uint32_t exception;
  };
  void look_for_overruns();
  [[nodiscard]] const char* name_of_work(std::uint32_t mark) const;

  Board& board_;
  const Image& image_;
  std::vector<std::uint32_t> buckets_, works_, counted_;
  std::vector<Overrun> overruns_;
};

}  // namespace finemote::emulator
