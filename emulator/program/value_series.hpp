// The quantities of parts over a run, looked at again and again.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"

namespace finemote::emulator {

/// Looks at every quantity of every part, but for families of them, at even times while the board runs.
class ValueSeries {
 public:
  /// The first look is at `from_ns`, the last one not after `to_ns`, both since power-on and not before now. At least a
  /// millisecond is between two looks, and their number is limited so that all series together stay small.
  /// @param board, outfit  outlive this and the run
  ValueSeries(Board& board, Outfit& outfit, std::int64_t from_ns, std::int64_t to_ns);
  ValueSeries(const ValueSeries&) = delete;
  ValueSeries& operator=(const ValueSeries&) = delete;

  /// `{part, value, unit, from_ns, every_ns, values}` with `from_ns` since `zero_ns`; six digits of each value, null
  /// where it is no finite number.
  [[nodiscard]] nlohmann::ordered_json document(std::int64_t zero_ns) const;

 private:
  struct Series {
    std::string part, value, unit;
    std::vector<double> seen = {};
  };
  void plan();
  void look();

  Board& board_;
  Outfit& outfit_;
  std::vector<Series> series_;
  std::int64_t from_ns_, every_ns_;
  std::size_t looks_ = 0, needed_ = 0;
};

}  // namespace finemote::emulator
