#include "generator/descriptor/pin_name.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace finemote::gen {

std::string PinName::text() const { return fmt::format("P{}{}", port, number); }

std::string PinName::initializer() const { return fmt::format("{{'{}', {}}}", port, number); }

std::optional<PinName> parse_pin(std::string_view text) {
  if (text.size() < 3 || text[0] != 'P' || text[1] < 'A' || text[1] > 'I') return std::nullopt;
  PinName pin{text[1], 0};
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), pin.number);
  if (error != std::errc() || pin.number > 15 || pin.text() != text) return std::nullopt;
  return pin;
}

PinName pin_name(std::string_view text) {
  const std::optional<PinName> pin = parse_pin(text);
  if (!pin) throw std::invalid_argument(fmt::format("'{}' is not a pin", text));
  return *pin;
}

std::uint32_t edge_interrupt(const PinName& pin) { return pin.number < 5 ? 6 + pin.number : pin.number < 10 ? 23 : 40; }

}  // namespace finemote::gen
