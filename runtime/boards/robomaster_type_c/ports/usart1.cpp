// USART1 at the 4-pin UART connector (printed UART2): TX PA9, RX PB7; DMA2 streams 5 and 7, channel 4.
#include "finemote/sections.hpp"
#include "runtime/boards/robomaster_type_c/clock.hpp"
#include "runtime/boards/robomaster_type_c/ports/uart_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f407::rcc;
namespace dma = stm32f407::dma;
using namespace robomaster_type_c;

FINEMOTE_DMA std::uint8_t ring[kUartRing];
FINEMOTE_DMA std::uint8_t transmit_buffer[kUartTransmit];

constexpr UartSetup kSetup{{0x40011000},
                           rcc::apb2enr,
                           rcc::kApb2Usart1,
                           kApb2Hz,
                           {'A', 9},
                           {'B', 7},
                           7,
                           {dma::kController2, 5},
                           {dma::kController2, 7},
                           4,
                           37,
                           68,
                           false,
                           ring,
                           transmit_buffer};
UartHardware hardware{kSetup};

}  // namespace

UartPort ports::usart1{hardware};

}  // namespace finemote

extern "C" void finemote_line_37() { finemote::hardware.on_usart(); }
extern "C" void finemote_line_68() { finemote::hardware.on_receive_dma(); }
