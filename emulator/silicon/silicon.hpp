// One chip: in what it is strict, and how much each time, drawn by a seed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "emulator/silicon/strictness.hpp"

namespace finemote::emulator {

class Silicon {
 public:
  /// As the manual reads.
  Silicon() = default;
  /// Two chips with the same ways and seed draw the same.
  Silicon(const std::vector<Strictness>& ways, std::uint64_t seed);

  /// Makes the chip so by just this much, whatever the range.
  void fix(Strictness way, std::uint32_t value) {
    is_[index(way)] = true;
    fixed_[index(way)] = value;
  }
  /// Makes the chip worse than so: it draws a hundred times the end of the range.
  void exceed(Strictness way) { fix(way, 100 * info_of(way).most); }
  /// The same by names. @throws std::invalid_argument for what is none
  static Silicon named(const std::vector<std::string>& names, std::uint64_t seed);

  [[nodiscard]] bool is(Strictness way) const { return is_[index(way)]; }
  /// A value of the range, its ends more often than what lies between. Only where the chip is so.
  [[nodiscard]] std::uint32_t draw(Strictness way);
  /// The same; 0 where the chip is not so.
  [[nodiscard]] std::uint32_t draw_or_zero(Strictness way) { return is(way) ? draw(way) : 0; }

  /// Random bits for a way without a range.
  [[nodiscard]] std::uint64_t bits(Strictness way) { return engines_[index(way)](); }

 private:
  static constexpr std::size_t index(Strictness way) { return static_cast<std::size_t>(way); }

  std::array<bool, kStrictnesses> is_{};
  std::array<std::optional<std::uint32_t>, kStrictnesses> fixed_;
  std::array<std::mt19937_64, kStrictnesses> engines_;  ///< one each: what one draws does not depend on the others
};

}  // namespace finemote::emulator
