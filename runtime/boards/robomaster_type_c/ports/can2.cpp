// CAN2 at the 4-pin CAN2 connector: RX PB5, TX PB6.
#include "runtime/boards/robomaster_type_c/ports/can_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f407::rcc;

constexpr robomaster_type_c::CanSetup kSetup{
    {0x40006800}, rcc::kApb1Can1 | rcc::kApb1Can2, {'B', 5}, {'B', 6}, 14, 63, 64, 66};
CanHardware hardware{kSetup};

}  // namespace

CanPort ports::can2{hardware};

}  // namespace finemote

extern "C" void finemote_line_63() { finemote::hardware.on_line(); }
extern "C" void finemote_line_64() { finemote::hardware.on_line(); }
extern "C" void finemote_line_66() { finemote::hardware.on_line(); }
