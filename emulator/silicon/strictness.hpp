// What a chip that uses the freedom its manual leaves is strict in: each way has a name, a range and a source.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace finemote::emulator {

enum class Strictness : std::uint8_t {
  dma_store,    ///< NDTR is ahead of memory
  dma_flag,     ///< and both are ahead of the end-of-transfer flag
  spi_busy,     ///< BSY falls late
  spi_kept,     ///< an SPI that is turned off keeps the byte it was to send
  i2c_pause,    ///< a more urgent interrupt comes between ADDR and the STOP of a one-byte read
  i2c_stop,     ///< a STOP comes late
  can_init,     ///< INAK comes late
  clock_ready,  ///< oscillators and the PLL take longer
  clock_rates,  ///< the watchdog's clock is off; those of board and parts are `run`'s to set
  cycle_count,  ///< CYCCNT stops in sleep whatever the debug clock does
  wake_up,      ///< the instruction after a WFI in flash is lost
  first_bytes,  ///< a receiver that is turned on hears noise
  ram_pattern,  ///< RAM holds anything at power-on
};
inline constexpr std::size_t kStrictnesses = 13;

struct StrictnessInfo {
  Strictness strictness;
  const char* name;  ///< as in `--silicon strict:NAME`
  std::uint32_t least, most;
  const char* unit;
  const char* what;
  const char* source;
};

/// All of them, in the order of Strictness.
const std::array<StrictnessInfo, kStrictnesses>& strictnesses();

inline const StrictnessInfo& info_of(Strictness way) { return strictnesses()[static_cast<std::size_t>(way)]; }

/// Null where there is none of that name.
const StrictnessInfo* find_strictness(std::string_view name);

/// The table of the page of the board.
std::string silicon_table();

}  // namespace finemote::emulator
