// Times as tests write them: 50_us.
#pragma once

#include "generator/units/duration.hpp"

namespace finemote::gen {

constexpr Duration operator""_ns(unsigned long long count) { return nanoseconds(static_cast<std::int64_t>(count)); }
constexpr Duration operator""_us(unsigned long long count) { return microseconds(static_cast<std::int64_t>(count)); }
constexpr Duration operator""_ms(unsigned long long count) { return milliseconds(static_cast<std::int64_t>(count)); }
constexpr Duration operator""_s(unsigned long long count) { return seconds(static_cast<std::int64_t>(count)); }

}  // namespace finemote::gen
