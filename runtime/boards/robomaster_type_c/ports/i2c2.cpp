// I2C2 at the 8-pin user connector: SDA PF0, SCL PF1.
#include "runtime/boards/robomaster_type_c/ports/i2c_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::I2cSetup kSetup{{0x40005800}, stm32f407::rcc::kApb1I2c2, {'F', 1}, {'F', 0}, 4, 33, 34};
I2cHardware hardware{kSetup};

}  // namespace

I2cPort ports::i2c2{hardware};

}  // namespace finemote

extern "C" void finemote_line_33() { finemote::hardware.on_event(); }
extern "C" void finemote_line_34() { finemote::hardware.on_error(); }
