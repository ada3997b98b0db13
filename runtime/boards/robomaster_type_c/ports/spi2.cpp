// SPI2 at the 8-pin user connector: SCK PB13, MISO PB14, MOSI PB15, chip select PB12. No DMA: its streams serve USART3.
#include "finemote/sections.hpp"
#include "runtime/boards/robomaster_type_c/clock.hpp"
#include "runtime/boards/robomaster_type_c/ports/spi_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f407::rcc;

constexpr robomaster_type_c::Pin kSelects[] = {{'B', 12}};
constexpr robomaster_type_c::SpiSetup kSetup{{0x40003800},
                                             rcc::apb1enr,
                                             rcc::kApb1Spi2,
                                             robomaster_type_c::kApb1Hz,
                                             {'B', 13},
                                             {'B', 14},
                                             {'B', 15},
                                             kSelects,
                                             1,
                                             false,
                                             {0, 0},
                                             {0, 0},
                                             0,
                                             36};
FINEMOTE_DMA robomaster_type_c::SpiBuffers buffers;
SpiHardware hardware{kSetup, buffers};

}  // namespace

SpiPort ports::spi2{hardware};

}  // namespace finemote

extern "C" void finemote_line_36() { finemote::hardware.on_line(); }
