#include "robot.hpp"

#include "finemote/sections.hpp"
#include "i2c_master.hpp"

namespace baseline {

FINEMOTE_DMA static std::uint8_t imu_ring[256];
FINEMOTE_DMA static std::uint8_t tether_ring[256];
finemote::Uart imu_uart{finemote::ports::usart1, 921'600, imu_ring};
finemote::Uart tether{finemote::ports::usart6, 115'200, tether_ring, finemote::UartFormat::k8E1};
finemote::H30Imu imu{nullptr, imu_uart};
PressureSensor sensors[kSensors]{PressureSensor{0}, PressureSensor{1}, PressureSensor{2}, PressureSensor{3}};
PulseBoard pulses;

void start_robot_parts() {
  start_i2c();
  pulses.start(static_cast<std::uint32_t>(finemote::PwmEsc::Config{}.neutral));
  for (PressureSensor& sensor : sensors) sensor.start();
  imu_uart.start();
  tether.start();
}

}  // namespace baseline
