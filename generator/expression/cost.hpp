// Operations whose work grows with their operands to the steps they count for.
//
// A step is what evaluating a small node of an expression takes, about 100 ns. Small operands add nothing: the node
// that holds them is counted already.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {

/// Bytes of a text or of an integer beyond 64 bits; 0 for all others, whose items are counted where they are visited.
inline std::size_t bytes_of(const Integer& value) { return value.is_small() ? 0 : bit_length(value) / 8; }
inline std::size_t bytes_of(const Value& value) {
  if (const auto* text = value.text()) return text->size();
  const auto* integer = value.as<Integer>();
  return integer != nullptr ? bytes_of(*integer) : 0;
}

/// Bytes moved, compared or summed up as a block.
inline std::size_t cost_of_block(std::size_t bytes) { return bytes / 64; }
/// Bytes looked at one by one.
inline std::size_t cost_of_bytes(std::size_t bytes) { return bytes / 8; }
/// A search whose every place may need the whole wanted text to be compared.
inline std::size_t cost_of_search(const std::string& text, const std::string& wanted) {
  const std::size_t places = text.size() < wanted.size() ? 0 : text.size() - wanted.size() + 1;
  return cost_of_bytes(text.size()) + places / 1024 * wanted.size();
}
/// The product of two integers of these sizes, or a division with a quotient and a divisor of these sizes.
inline std::size_t cost_of_product(std::size_t bytes, std::size_t other_bytes) {
  return (bytes / 8) * (other_bytes / 8) / 32;
}
inline std::size_t cost_of_division(const Integer& dividend, const Integer& divisor) {
  const std::size_t most = bytes_of(dividend);
  const std::size_t least = bytes_of(divisor);
  return cost_of_block(most + least) +
         cost_of_product(most > least ? most - least + 8 : 0, std::max<std::size_t>(least, 8));
}
/// Printing in decimal; what is too long to be printed is refused before.
inline std::size_t cost_of_digits(const Integer& value) {
  const std::size_t bytes = std::min(bytes_of(value), kMaxIntegerDigits / 2);
  return cost_of_product(bytes, bytes);
}

inline std::size_t cost_of_printing(const Value& value) {
  const auto* integer = value.as<Integer>();
  return integer != nullptr ? cost_of_digits(*integer) : cost_of_bytes(bytes_of(value));
}

}  // namespace finemote::gen::expression
