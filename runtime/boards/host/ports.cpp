// The ports of the vocabulary on the host: each with the wire it ends in.
#include "runtime/boards/host/can_wire.hpp"
#include "runtime/boards/host/i2c_wire.hpp"
#include "runtime/boards/host/pins.hpp"
#include "runtime/boards/host/spi_wire.hpp"
#include "runtime/boards/host/uart_wire.hpp"

namespace finemote {

namespace host {
UartHardware usart1, usart3, usart6;
CanHardware can1, can2;
I2cHardware i2c2, i2c3;
SpiHardware spi1, spi2;
PwmHardware pwm1, pwm2, pwm3, pwm4, pwm5, pwm6, pwm7;
GpioHardware gpio;
}  // namespace host

namespace ports {
UartPort usart1{host::usart1}, usart3{host::usart3}, usart6{host::usart6};
CanPort can1{host::can1}, can2{host::can2};
I2cPort i2c2{host::i2c2}, i2c3{host::i2c3};
SpiPort spi1{host::spi1}, spi2{host::spi2};
PwmPort pwm1{host::pwm1}, pwm2{host::pwm2}, pwm3{host::pwm3}, pwm4{host::pwm4};
PwmPort pwm5{host::pwm5}, pwm6{host::pwm6}, pwm7{host::pwm7};
GpioPort gpio{host::gpio};
}  // namespace ports

}  // namespace finemote
