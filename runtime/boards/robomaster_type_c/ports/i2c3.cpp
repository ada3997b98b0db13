// I2C3 on the board, to the IST8310 magnetometer: SCL PA8, SDA PC9.
#include "runtime/boards/robomaster_type_c/ports/i2c_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::I2cSetup kSetup{{0x40005C00}, stm32f407::rcc::kApb1I2c3, {'A', 8}, {'C', 9}, 4, 72, 73};
I2cHardware hardware{kSetup};

}  // namespace

I2cPort ports::i2c3{hardware};

}  // namespace finemote

extern "C" void finemote_line_72() { finemote::hardware.on_event(); }
extern "C" void finemote_line_73() { finemote::hardware.on_error(); }
