// Turns words and numbers into a line of text without the C library's formatting.
#pragma once

#include <cstddef>
#include <cstdint>

namespace finemote {

/// A line of at most N characters; what does not fit is left out.
template <std::size_t N>
class Text {
 public:
  template <std::size_t size>
  Text& add(const char (&text)[size]) {
    return add(text, size - 1);
  }

  Text& add_number(std::int32_t value) {
    if (value < 0) put('-');
    return add_digits(value < 0 ? 0U - static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value));
  }

  /// Two decimals, rounded; values beyond +-10^7 are cut there, NaN is 0.
  Text& add_hundredths(float value) {
    constexpr float kLimit = 1e7F;
    const float bounded = value > kLimit ? kLimit : value < -kLimit ? -kLimit : value == value ? value : 0;
    const float scaled = bounded * 100;
    const auto hundredths = static_cast<std::int32_t>(scaled + (scaled < 0 ? -0.5F : 0.5F));
    const std::uint32_t size = static_cast<std::uint32_t>(hundredths < 0 ? -hundredths : hundredths);
    if (hundredths < 0) put('-');
    add_digits(size / 100);
    put('.');
    put(static_cast<char>('0' + size / 10 % 10));
    put(static_cast<char>('0' + size % 10));
    return *this;
  }

  [[nodiscard]] const std::uint8_t* bytes() const { return text_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  Text& add(const char* text, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) put(text[i]);
    return *this;
  }
  Text& add_digits(std::uint32_t value) {
    char digits[10];
    unsigned count = 0;
    do {
      digits[count++] = static_cast<char>('0' + value % 10);
      value /= 10;
    } while (value != 0);
    while (count != 0) put(digits[--count]);
    return *this;
  }
  void put(char c) {
    if (size_ < N) text_[size_++] = static_cast<std::uint8_t>(c);
  }

  std::uint8_t text_[N];
  std::size_t size_ = 0;
};

}  // namespace finemote
