// LED, buzzer, key and battery: what they drive, what they see, and what they do without data.
#include <cmath>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "finemote/devices/battery.hpp"
#include "finemote/devices/buzzer.hpp"
#include "finemote/devices/key.hpp"
#include "finemote/devices/led.hpp"
#include "finemote/fault.hpp"

namespace {

using namespace finemote;

std::uint32_t pulse(const PwmHardware& output) { return output.writes.empty() ? 0 : output.writes.back().pulse; }

// ---------------------------------------------------------------------------------------------------------------- led

struct Lamp {
  Lamp() {
    bench::reset();
    for (PwmBus* bus : {&red, &green, &blue}) bus->start();
    host::advance(10 * kSecond);
  }
  void flush() {
    for (PwmBus* bus : {&red, &green, &blue}) bus->flush();
  }
  void show(Led& led, float r, float g, float b, Duration age = 0) {
    led.command.red = r;
    led.command.green = g;
    led.command.blue = b;
    led.command.origin = now() - age;
    led.command.valid = true;
    led.handle();
    led.update();
    flush();
  }
  PwmBus red{ports::led_red, 1000000}, green{ports::led_green, 1000000}, blue{ports::led_blue, 1000000};
  PwmChannel green_channel{green, 0}, blue_channel{blue, 0};
};

}  // namespace

TEST_CASE_METHOD(Lamp, "a colour becomes shares of the repetition period") {
  Led led{{0.5F, kSecond, Led::OnLoss::kOff, 0}, {red, 0}, &green_channel, &blue_channel};
  show(led, 1, 0.5F, 0);
  CHECK(host::led_red.period == 1000000);
  CHECK(pulse(host::led_red) == 500000);
  CHECK(pulse(host::led_green) == 250000);
  CHECK(pulse(host::led_blue) == 0);
  CHECK(led.state.valid);
  CHECK(led.state.green == 0.5F);
}

TEST_CASE_METHOD(Lamp, "one LED shows the brightest colour; two uses are enough") {
  Led alone{{1, kSecond, Led::OnLoss::kOff, 0}, {red, 0}, nullptr, nullptr};
  show(alone, 0.1F, 0.7F, 0.2F);
  CHECK(pulse(host::led_red) == 700000);
  CHECK(host::led_green.writes.empty());
  Led pair{{1, kSecond, Led::OnLoss::kOff, 0}, {red, 0}, &green_channel, nullptr};
  show(pair, 0.1F, 0.7F, 0.2F);
  CHECK(pulse(host::led_red) == 100000);
  CHECK(pulse(host::led_green) == 700000);
}

TEST_CASE_METHOD(Lamp, "shares are cut to 0..1, and what is no number is dark") {
  Led led{{1, kSecond, Led::OnLoss::kOff, 0}, {red, 0}, &green_channel, &blue_channel};
  show(led, 7, -1, NAN);
  CHECK(pulse(host::led_red) == 1000000);
  CHECK(pulse(host::led_green) == 0);
  CHECK(pulse(host::led_blue) == 0);
}

TEST_CASE_METHOD(Lamp, "without fresh data an LED stays, goes dark or blinks") {
  Led hold{{1, kSecond, Led::OnLoss::kHold, 0}, {red, 0}, nullptr, nullptr};
  show(hold, 0.5F, 0, 0);
  show(hold, 1, 0, 0, kSecond + 1);
  CHECK(pulse(host::led_red) == 500000);
  Led off{{1, kSecond, Led::OnLoss::kOff, 0}, {red, 0}, nullptr, nullptr};
  show(off, 1, 0, 0, kSecond + 1);
  CHECK(pulse(host::led_red) == 0);

  Led blink{{1, kSecond, Led::OnLoss::kBlink, 200 * kMillisecond}, {green, 0}, nullptr, nullptr};
  unsigned turns = 0;
  std::uint32_t last = pulse(host::led_green);
  for (int i = 0; i < 100; ++i) {
    host::advance(10 * kMillisecond);
    blink.handle();
    flush();
    turns += pulse(host::led_green) != last ? 1 : 0;
    last = pulse(host::led_green);
  }
  CHECK(turns == 10);  // five times on and off in a second
}

TEST_CASE_METHOD(Lamp, "safe is dark, or goes on blinking") {
  Led led{{1, kSecond, Led::OnLoss::kHold, 0}, {red, 0}, nullptr, nullptr};
  show(led, 1, 0, 0);
  led.safe();
  flush();
  CHECK(pulse(host::led_red) == 0);
}

// ------------------------------------------------------------------------------------------------------------- buzzer

namespace {

struct Horn {
  Horn() {
    bench::reset();
    bus.start();
    host::advance(10 * kSecond);
  }
  void play(Buzzer& buzzer, float frequency, float volume, Duration age = 0) {
    buzzer.command.frequency = frequency;
    buzzer.command.volume = volume;
    buzzer.command.origin = now() - age;
    buzzer.command.valid = true;
    buzzer.handle();
    buzzer.update();
    bus.flush();
  }
  PwmBus bus{ports::buzzer, 250000};
};

}  // namespace

TEST_CASE_METHOD(Horn, "a tone is a period and at most half of it on") {
  Buzzer buzzer{{1, 200 * kMillisecond}, {bus, 0}};
  play(buzzer, 1000, 1);
  CHECK(host::buzzer.period == 1000000);
  CHECK(pulse(host::buzzer) == 500000);
  play(buzzer, 2000, 0.5F);
  CHECK(host::buzzer.period == 500000);
  CHECK(pulse(host::buzzer) == 62500);
  CHECK(buzzer.state.frequency == 2000);
}

TEST_CASE_METHOD(Horn, "it is silent with old data, a pitch out of range, no number, and when made safe") {
  Buzzer buzzer{{1, 200 * kMillisecond}, {bus, 0}};
  const auto [frequency, age] =
      GENERATE(table<float, Duration>({{440.0F, 200 * kMillisecond + 1}, {5.0F, 0}, {30000.0F, 0}, {NAN, 0}}));
  play(buzzer, 440, 1);
  CHECK(pulse(host::buzzer) > 0);
  play(buzzer, frequency, 1, age);
  CHECK(pulse(host::buzzer) == 0);
  play(buzzer, 440, 1);
  CHECK(pulse(host::buzzer) > 0);
  buzzer.safe();
  bus.flush();
  CHECK(pulse(host::buzzer) == 0);
}

TEST_CASE_METHOD(Horn, "an output whose timer drives others keeps its period, which is counted") {
  host::buzzer.alone = false;
  const auto before = fault_count(Module::pwm, 16);
  Buzzer buzzer{{1, 200 * kMillisecond}, {bus, 0}};
  play(buzzer, 1000, 1);
  CHECK(host::buzzer.period == 250000);
  CHECK(fault_count(Module::pwm, 16) == before + 1);
}

// ---------------------------------------------------------------------------------------------------------------- key

namespace {

struct Board {
  Board() {
    bench::reset();
    ports::gpio.configure(pin_number('A', 0), PinSetting::kInputPullUp);
  }
  void down(bool pressed) { host::gpio.levels[pin_number('A', 0)] = !pressed; }
  Key key{{20 * kMillisecond}, {ports::gpio, pin_number('A', 0), true}};
};

}  // namespace

TEST_CASE_METHOD(Board, "a key counts when it has been down long enough, and bounces are not seen") {
  bench::robot().fast = [&] { key.update(); };
  bench::at(10 * kMillisecond, [&] { CHECK_FALSE(key.state.valid); });
  bench::at(101 * kMillisecond, [&] { down(true); });
  bench::at(106 * kMillisecond, [&] { down(false); });
  bench::at(111 * kMillisecond, [&] { down(true); });
  bench::at(129 * kMillisecond, [&] { CHECK_FALSE(key.state.pressed); });
  bench::at(141 * kMillisecond, [&] {
    CHECK(key.state.pressed);
    CHECK(key.state.held == 25 * kMillisecond);
    CHECK(key.state.origin == 140 * kMillisecond);
  });
  bench::at(201 * kMillisecond, [&] { down(false); });
  bench::run(300 * kMillisecond);
  CHECK(key.state.valid);
  CHECK_FALSE(key.state.pressed);
  CHECK(key.state.presses == 1);
}

// ------------------------------------------------------------------------------------------------------------ battery

namespace {

struct Supply {
  Supply() {
    bench::reset();
    ports::adc3.start(8, pin_number('F', 10));
    bench::robot().slow = [this] { battery.update(); };
  }
  static void volts(float value) { host::adc3.codes[8] = static_cast<std::uint16_t>(value / 33.3F * 4095 + 0.5F); }
  BatterySense battery{{22, 20, 0, 100 * kMillisecond}, {ports::adc3, 8, 33.3F}};
};

}  // namespace

TEST_CASE_METHOD(Supply, "a code becomes volts, one update late") {
  volts(24);
  bench::at(5 * kMillisecond, [&] { CHECK_FALSE(battery.state.valid); });
  bench::run(51 * kMillisecond);
  CHECK(battery.state.valid);
  CHECK(battery.state.voltage == Approx(24).margin(0.01));
  CHECK(battery.state.origin == 40 * kMillisecond);
  CHECK_FALSE(battery.state.low);
}

TEST_CASE_METHOD(Supply, "low and empty need their time, and come back above a gap") {
  volts(24);
  bench::at(101 * kMillisecond, [] { volts(21); });
  bench::at(151 * kMillisecond, [&] { CHECK_FALSE(battery.state.low); });
  bench::at(251 * kMillisecond, [&] {
    CHECK(battery.state.low);
    CHECK_FALSE(battery.state.empty);
    volts(19);
  });
  bench::at(401 * kMillisecond, [&] {
    CHECK(battery.state.empty);
    volts(22.2F);
  });
  bench::at(601 * kMillisecond, [&] {
    CHECK_FALSE(battery.state.empty);
    CHECK(battery.state.low);  // above by less than the gap
    volts(23);
  });
  bench::run(800 * kMillisecond);
  CHECK_FALSE(battery.state.low);
}

TEST_CASE_METHOD(Supply, "nothing connected, the end of the scale and no conversion are not valid") {
  const int fault = GENERATE(0, 1, 2);
  volts(24);
  bench::at(101 * kMillisecond, [&] {
    CHECK(battery.state.valid);
    if (fault == 0) volts(0.5F);
    if (fault == 1) host::adc3.codes[8] = AdcPort::kFullScale;
    host::adc3.broken = fault == 2;
  });
  bench::run(700 * kMillisecond);
  CHECK_FALSE(battery.state.valid);
}
