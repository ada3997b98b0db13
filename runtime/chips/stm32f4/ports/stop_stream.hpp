// The end of a DMA stream, for the ports that use some.
#pragma once

#include "runtime/chips/stm32f4/registers/dma.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote::stm32f4 {

/// Turns a stream off, waits until it has stopped, and clears its flags. From everywhere.
///
/// A stream stops when the item it moves is moved (RM0090 10.3.17): at most the other seven of its controller come
/// first, eight cycles each (AN4031 2.1). It is waited for a microsecond.
/// @return false: it has not stopped by then
[[nodiscard]] inline bool stop(const DmaStream& stream) {
  constexpr std::uint32_t kLimit = cortex_m4::kCoreHz / 1'000'000;
  stream.cr().clear(dma::kEnable);
  const bool has_stopped = wait_within(stream.cr(), dma::kEnable, 0, cortex_m4::cycles(), kLimit);
  stream.clear_flags(dma::kFlagsAll);
  return has_stopped;
}

}  // namespace finemote::stm32f4
