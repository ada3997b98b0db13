// USART3 at the 3-pin DBUS connector, behind the board's inverter: RX PC11; DMA1 streams 1 and 3, channel 4.
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

constexpr UartSetup kSetup{{0x40004800},
                           rcc::apb1enr,
                           rcc::kApb1Usart3,
                           kApb1Hz,
                           {'C', 10},
                           {'C', 11},
                           7,
                           {dma::kController1, 1},
                           {dma::kController1, 3},
                           4,
                           39,
                           12,
                           true,
                           ring,
                           transmit_buffer};
UartHardware hardware{kSetup};

}  // namespace

UartPort ports::usart3{hardware};

}  // namespace finemote

extern "C" void finemote_line_39() { finemote::hardware.on_usart(); }
extern "C" void finemote_line_12() { finemote::hardware.on_receive_dma(); }
