// CAN1 at the 2-pin CAN1 connector: RX PD0, TX PD1.
#include "runtime/boards/robomaster_type_c/ports/can_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f407::rcc;

constexpr robomaster_type_c::CanSetup kSetup{{0x40006400}, rcc::kApb1Can1, {'D', 0}, {'D', 1}, 0, 19, 20, 22};
CanHardware hardware{kSetup};

}  // namespace

CanPort ports::can1{hardware};

}  // namespace finemote

extern "C" void finemote_line_19() { finemote::hardware.on_line(); }
extern "C" void finemote_line_20() { finemote::hardware.on_line(); }
extern "C" void finemote_line_22() { finemote::hardware.on_line(); }
