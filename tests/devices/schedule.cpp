#include "finemote/schedule.hpp"

#include "bench.hpp"
#include "finemote/bus_counters.hpp"

namespace bench {

Robot& robot() {
  static Robot the_robot;
  return the_robot;
}

void reset() {
  using namespace finemote;
  host::reset();
  forget_buses();
  for (I2cHardware* wire : {&host::i2c2, &host::i2c3}) wire->reset();
  for (UartHardware* line : {&host::usart1, &host::usart3, &host::usart6}) line->reset();
  for (SpiHardware* wire : {&host::spi1, &host::spi2}) *wire = {};
  for (CanHardware* wire : {&host::can1, &host::can2}) *wire = {};
  for (PwmHardware* output :
       {&host::pwm1, &host::led_red, &host::led_green, &host::led_blue, &host::buzzer, &host::imu_heater}) {
    *output = {};
  }
  host::gpio = {};
  for (EdgeHardware* line : {&host::exti0, &host::exti3, &host::exti4, &host::exti5}) *line = {};
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
  finemote::complete(0);
}
void slow() {
  call(robot().slow);
  finemote::complete(1);
}

constexpr finemote::Bucket buckets[] = {{fast, 5'000'000, 48, 4, 3}, {slow, 10'000'000, 49, 5, 3}};

}  // namespace
}  // namespace bench

extern "C" const finemote::Schedule finemote_schedule{
    "Bench", 1'000'000, bench::buckets, finemote::Overrun::skip, bench::start, bench::safe, nullptr};
