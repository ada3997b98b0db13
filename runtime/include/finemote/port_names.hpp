// The names of ports, finemote::ports: those of the linked board where its generated headers are searched for. Else
// those of every shipped board, with which whatever is generated for one of them compiles.
#pragma once

#include "finemote/ports.hpp"

#if __has_include(<board/port_names.hpp>)
#include <board/port_names.hpp>
#else
namespace finemote::ports {

extern UartPort usart1, usart3, usart6, usart2;
extern CanPort can1, can2;
extern I2cPort i2c2, i2c3, i2c1;
extern SpiPort spi1, spi2;
extern PwmPort pwm1, pwm2, pwm3, pwm4, pwm5, pwm6, pwm7, led_red, led_green, led_blue, buzzer, imu_heater, led_orange;
extern EdgePort exti0, exti3, exti4, exti5, exti1;
extern AdcPort adc3;
extern GpioPort gpio;

}  // namespace finemote::ports
#endif
