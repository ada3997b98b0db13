// The format of a serial line, as descriptors write it: `8N1`, `8E1_inverted`.
#pragma once

#include <cstdint>
#include <string_view>

namespace finemote::gen {

/// A byte on the line: a start bit, eight data bits, perhaps parity, stop bits.
struct LineFormat {
  bool has_even_parity = false;
  int stop_bits = 1;
  bool is_inverted = false;  ///< the line is low where it rests

  /// Bits of one byte on the wire: 10 for `8N1`.
  [[nodiscard]] std::int64_t bits_per_byte() const { return 1 + 8 + (has_even_parity ? 1 : 0) + stop_bits; }
};

/// Reads what the schema accepts.
LineFormat line_format(std::string_view text);

}  // namespace finemote::gen
