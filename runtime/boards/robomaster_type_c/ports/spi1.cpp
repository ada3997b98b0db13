// SPI1 to the BMI088 on the board: SCK PB3, MISO PB4, MOSI PA7; DMA2 streams 0 and 3, channel 3.
#include "finemote/sections.hpp"
#include "runtime/boards/robomaster_type_c/clock.hpp"
#include "runtime/boards/robomaster_type_c/ports/spi_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f407::rcc;
namespace dma = stm32f407::dma;

constexpr robomaster_type_c::Pin kSelects[] = {{'A', 4}, {'B', 0}};  // accelerometer, gyroscope
constexpr robomaster_type_c::SpiSetup kSetup{{0x40013000},
                                             rcc::apb2enr,
                                             rcc::kApb2Spi1,
                                             robomaster_type_c::kApb2Hz,
                                             {'B', 3},
                                             {'B', 4},
                                             {'A', 7},
                                             kSelects,
                                             2,
                                             true,
                                             {dma::kController2, 0},
                                             {dma::kController2, 3},
                                             3,
                                             56};
FINEMOTE_DMA robomaster_type_c::SpiBuffers buffers;
SpiHardware hardware{kSetup, buffers};

}  // namespace

SpiPort ports::spi1{hardware};

}  // namespace finemote

extern "C" void finemote_line_56() { finemote::hardware.on_line(); }
