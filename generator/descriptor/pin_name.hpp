// `PA9` to the port and the number of a pin, and back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace finemote::gen {

/// A pin of a chip.
struct PinName {
  char port = 'A';           ///< A to I
  std::uint32_t number = 0;  ///< 0 to 15

  /// `PA9`
  [[nodiscard]] std::string text() const;
  /// As code of a chip writes it: `{'A', 9}`.
  [[nodiscard]] std::string initializer() const;

  friend bool operator==(const PinName& a, const PinName& b) { return a.port == b.port && a.number == b.number; }
};

/// @return  none: it is not spelled `P`, a letter A to I, a number 0 to 15 without a leading zero
std::optional<PinName> parse_pin(std::string_view text);

/// The same for a name that was checked before: by the schema of board files, or when the robot was built.
/// @throws std::invalid_argument  it is none
PinName pin_name(std::string_view text);

/// Interrupt line of the EXTI line of a pin of an STM32F4, whose routine looks at all pins that share it: RM0090 12.2,
/// table 62.
std::uint32_t edge_interrupt(const PinName& pin);

}  // namespace finemote::gen
