// Numbers of the exceptions of a Cortex-M: PM0214 2.3.2.
#pragma once

#include <cstdint>

namespace finemote::gen {

inline constexpr std::uint32_t kSysTickException = 15;

/// Of an interrupt line.
constexpr std::uint32_t exception_of(std::uint32_t line) { return 16 + line; }

}  // namespace finemote::gen
