// The tests, in groups of those that one procedure answers. A group fills in what bench_plan.hpp lists under its number
// in the table of main.cpp; every wait in it ends by itself.
#pragma once

namespace finemote::bench_kit {

/// At the clock the chip starts with: how long the LSI takes to start.
void time_low_oscillator();
/// At the same clock: how long crystal and PLL take, and the rate of the crystal by the HSI.
void time_oscillators();
/// The board's clock against the crystal, the LSI, and the cycle counter.
void measure_clocks();
/// The identities of the parts on the board.
void ask_inertial_sensor();
void ask_magnetometer();
/// The cycle counter and the instructions behind a WFI.
void measure_sleep();
/// The flash with its accelerator and without.
void measure_flash();
void measure_interrupt();
/// What comes later than the manual reads, and what receivers hear before anybody sends.
void listen_to_silence();
void watch_spi();
void watch_i2c();
void watch_can();
/// Wire times; of the last two over jumpers, where there are any.
void measure_i2c_wire();
void measure_can_wire();
void measure_serial_wire();
void measure_spi_wire();
/// The release interrupt of the robot, the routines of its buses, and its stages. Masks all interrupts from then on.
void measure_robot();

}  // namespace finemote::bench_kit
