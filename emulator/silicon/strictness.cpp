#include "emulator/silicon/strictness.hpp"

namespace finemote::emulator {
namespace {

constexpr const char* kDmaSource =
    "reported of STM32F4 by others (efton.sk, STM32 gotchas 20), without a figure; a choice: seven other streams of "
    "the "
    "controller come first (AN4031 2.1), eight cycles each";

constexpr std::array<StrictnessInfo, kStrictnesses> kAll = {{
    {Strictness::dma_store, "dma_store", 0, 64, "cycles of the core",
     "a byte is in memory so long after NDTR counted it", kDmaSource},
    {Strictness::dma_flag, "dma_flag", 0, 64, "cycles of the core",
     "the flag of the end of a transfer or lap is set so long after the last byte is in memory", kDmaSource},
    {Strictness::spi_busy, "spi_busy", 1, 2, "half bits",
     "BSY falls so long after the last bit was sampled: the last edge of the clock is still to come",
     "RM0090 28.3.7, 28.3.8"},
    {Strictness::spi_kept, "spi_kept", 1, 1, "",
     "a byte that waits in the transmit register when the SPI is turned off is sent when it is turned on again",
     "RM0090 28.3.8 says to turn it off only when the register is empty, not what becomes of a byte in it"},
    {Strictness::i2c_pause, "i2c_pause", 0, 40, "us",
     "a more urgent interrupt takes so long between the clearing of ADDR and the STOP of a one-byte read",
     "RM0090 27.3.3: STOP is asked for just after ADDR is cleared"},
    {Strictness::i2c_stop, "i2c_stop", 0, 800, "ns", "a STOP takes so much longer than a bit",
     "UM10204, table 10: a rise of 300 ns in fast mode, which is part of the bit; half a microsecond is a choice"},
    {Strictness::can_init, "can_init", 0, 8'000, "us", "INAK follows INRQ so late",
     "RM0090 32.4.1 gives no time; ST's drivers allow 10 ms"},
    {Strictness::clock_ready, "clock_ready", 100, 1'000, "%", "start of crystal, PLL and LSI, of the typical time",
     "DS8626 5.3.8 to 5.3.10; ST's drivers allow the crystal 100 ms and the PLL 2 ms"},
    {Strictness::clock_rates, "clock_rates", 17'000, 47'000, "Hz",
     "rate of the LSI, which drives the watchdog; the crystal and the clocks of parts are off as well, by up to "
     "`clock_ppm` of the board and `tolerance_ppm` of the parts, either way",
     "DS8626 5.3.9; the board file and the descriptors name theirs"},
    {Strictness::cycle_count, "cycle_count", 1, 1, "", "the cycle counter stops in sleep also with DBG_SLEEP set",
     "RM0090 38.16.3; reported both ways"},
    {Strictness::wake_up, "wake_up", 0, 1, "instructions",
     "lost behind a WFI in flash whose address ends in 2 or 4 (of 8), with DBG_SLEEP set",
     "ES0182, debugging Sleep/Stop mode with WFE/WFI entry"},
    {Strictness::first_bytes, "first_bytes", 0, 3, "bytes", "of noise that a receiver hears once it is turned on",
     "lines float until the other side drives them"},
    {Strictness::ram_pattern, "ram_pattern", 1, 1, "", "RAM holds random bytes at power-on",
     "RM0090 2.3.1: its contents are not defined"},
}};

}  // namespace

const std::array<StrictnessInfo, kStrictnesses>& strictnesses() { return kAll; }

const StrictnessInfo* find_strictness(std::string_view name) {
  for (const StrictnessInfo& info : kAll) {
    if (name == info.name) return &info;
  }
  return nullptr;
}

std::string silicon_table() {
  std::string table = "| name | range | what | source |\n|---|---|---|---|\n";
  for (const StrictnessInfo& it : kAll) {
    std::string range;
    if (it.unit[0] != '\0') {
      range = std::to_string(it.least);
      if (it.most != it.least) range += " to " + std::to_string(it.most);
      range += std::string(" ") + it.unit;
    }
    table += std::string("| `") + it.name + "` | " + range + " | " + it.what + " | " + it.source + " |\n";
  }
  return table;
}

}  // namespace finemote::emulator
