// USART6 at the 3-pin UART connector (printed UART1): TX PG14, RX PG9; DMA2 streams 1 and 6, channel 5.
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

constexpr UartSetup kSetup{{0x40011400},
                           rcc::apb2enr,
                           rcc::kApb2Usart6,
                           kApb2Hz,
                           {'G', 14},
                           {'G', 9},
                           8,
                           {dma::kController2, 1},
                           {dma::kController2, 6},
                           5,
                           71,
                           57,
                           false,
                           ring,
                           transmit_buffer};
UartHardware hardware{kSetup};

}  // namespace

UartPort ports::usart6{hardware};

}  // namespace finemote

extern "C" void finemote_line_71() { finemote::hardware.on_usart(); }
extern "C" void finemote_line_57() { finemote::hardware.on_receive_dma(); }
