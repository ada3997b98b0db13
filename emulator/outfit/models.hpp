// The parts and plants that a scenario can place, one function each: its row, in a file with its behaviour. They are
// listed in models.cpp.
#pragma once

#include "emulator/scenario/grammar.hpp"

namespace finemote::emulator {

// On serial lines.
scenario::Model h30_imu();
scenario::Model dbus_receiver();
scenario::Model sbus_receiver();
scenario::Model host_terminal();
scenario::Model host_computer();
// On I2C buses.
scenario::Model tca9548a();
scenario::Model pca9685();
scenario::Model ms5837();
scenario::Model ist8310();
scenario::Model register_bank();
// On SPI and CAN buses.
scenario::Model bmi088();
scenario::Model dji_motor();
scenario::Model can_listener();
// On PWM outputs.
scenario::Model pwm_output();
scenario::Model thruster();
// Wires.
scenario::Model serial_jumper();
scenario::Model spi_jumper();
// What a board has at its pins.
scenario::Model load();
scenario::Model button();
scenario::Model battery();
// Bodies and what moves them.
scenario::Model standing_body();
scenario::Model submerged_body();
scenario::Model mecanum_base();
scenario::Model weights();

}  // namespace finemote::emulator
