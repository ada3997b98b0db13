// Turns a written quantity (`5ms`, `400 kHz`, `0x76`) into an exact integer in its base unit, or says what is wrong.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>

#include "generator/diagnostic/code.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::units {

/// Why a text is no quantity of the wanted kind; `message` and `hint` are ready for a Diagnostic (`hint` may be empty).
struct Fault {
  Code code;
  std::string message;
  std::string hint;
};

/// Either the value or the fault.
template <typename T>
class Result {
 public:
  Result(T value) : content_(value) {}                 // NOLINT(google-explicit-constructor)
  Result(Fault fault) : content_(std::move(fault)) {}  // NOLINT(google-explicit-constructor)
  explicit operator bool() const { return content_.index() == 0; }
  const T& operator*() const { return std::get<0>(content_); }
  [[nodiscard]] const Fault& fault() const { return std::get<1>(content_); }

 private:
  std::variant<T, Fault> content_;
};

// A quantity is `number unit`: number [0-9]+(\.[0-9]+)?, at most one blank, then the unit, case-sensitive. The value
// has to be whole in the base unit and fit 64 bits with sign. No locale is consulted. Faults: FM3030 (no unit), FM3031
// (other unit), FM3032 (not whole in the base unit), FM3033 (no quantity at all), FM3034 (too large).

Result<Duration> parse_duration(std::string_view text);       ///< ns us ms s
Result<std::int64_t> parse_frequency(std::string_view text);  ///< Hz kHz MHz -> Hz
Result<std::int64_t> parse_bitrate(std::string_view text);    ///< bit/s kbit/s Mbit/s baud -> bit/s
Result<std::int64_t> parse_bits(std::string_view text);       ///< bit -> bit
Result<double> parse_percent(std::string_view text);          ///< % -> fraction (`40%` -> 0.4), correctly rounded

/// What a number without unit probably means, for the hint of FM3030: a quantity from `least` to `most` (in the base
/// unit), with the first unit of `preferred` that makes it one. Other faults stay as they are.
/// @param parse  parse_duration, parse_frequency, parse_bitrate
template <typename T>
Fault with_meant_unit(Fault fault, std::string_view text, std::initializer_list<std::string_view> preferred,
                      Result<T> (*parse)(std::string_view), double least, double most);

/// A bare integer, decimal or 0x, as `index channel id address` are written. Faults: FM3035, FM3034.
Result<std::uint32_t> parse_bare(std::string_view text);

/// A signed decimal or 0x integer, or a signed decimal number with optional exponent: values of params without
/// conversion. `unit` may follow; empty or "1": none may. Faults: FM3031 (converts where known), FM3033, FM3034.
Result<std::int64_t> parse_integer(std::string_view text, std::string_view unit = {});
Result<double> parse_real(std::string_view text, std::string_view unit = {});

/// `2500000` -> `2500us`: the largest of s, ms, us, ns that divides it; 0 -> `0s`.
std::string format_duration(Duration time);

/// The same with a blank, as generated comments and tables spell periods: `2500000` -> `2500 us`.
std::string spaced_duration(Duration time);

/// `2500001` -> `2.500001ms`: exact as well, in the largest unit that leaves a number above 1; 0 -> `0s`.
std::string readable_duration(Duration time);

}  // namespace finemote::gen::units
