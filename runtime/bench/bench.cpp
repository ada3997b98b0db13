#include "finemote/bench/bench.hpp"

#include "finemote/bus_counters.hpp"
#include "finemote/schedule.hpp"

namespace finemote::bench {

Robot& robot() {
  static Robot the_robot;
  return the_robot;
}

void reset() {
  host::reset();
  forget_buses();
  for (I2cHardware* wire : {&host::i2c1, &host::i2c2, &host::i2c3}) wire->reset();
  for (UartHardware* line : {&host::usart1, &host::usart2, &host::usart3, &host::usart6}) line->reset();
  for (SpiHardware* wire : {&host::spi1, &host::spi2}) *wire = {};
  for (CanHardware* wire : {&host::can1, &host::can2}) *wire = {};
  for (PwmHardware* output :
       {&host::pwm1, &host::pwm2, &host::pwm3, &host::pwm4, &host::pwm5, &host::pwm6, &host::pwm7, &host::led_red,
        &host::led_green, &host::led_blue, &host::led_orange, &host::buzzer, &host::imu_heater}) {
    *output = {};
  }
  host::gpio = {};
  for (EdgeHardware* line : {&host::exti0, &host::exti1, &host::exti3, &host::exti4, &host::exti5}) *line = {};
  host::adc3 = {};
  robot() = {};
}

namespace {

void call(const std::function<void()>& function) {
  if (function) function();
}

void start() { call(robot().start); }
void safe() { call(robot().safe); }
void fast() {
  call(robot().fast);
  complete(0);
}
void slow() {
  call(robot().slow);
  complete(1);
}

constexpr finemote::Bucket buckets[] = {{fast, 5'000'000, 48, 4, 3}, {slow, 10'000'000, 49, 5, 3}};

}  // namespace
}  // namespace finemote::bench

extern "C" const finemote::Schedule finemote_schedule{"Bench",
                                                      1'000'000,
                                                      finemote::bench::buckets,
                                                      finemote::Overrun::skip,
                                                      finemote::bench::start,
                                                      finemote::bench::safe,
                                                      nullptr};
