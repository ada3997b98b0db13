// As the robot's public firmware is: a timer interrupt sets a flag, the main loop looks at it and calls all devices in
// the order of an array; the bus is waited for, and what it answers is not looked at.
#include "i2c_master.hpp"
#include "marks.hpp"
#include "robot.hpp"
#include "start.hpp"

namespace baseline {

/// As long as the vendor's library waits for a bus that is not free, and what the public firmware passes it otherwise.
const I2cPolicy i2c_policy{25 * finemote::kMillisecond, 10 * finemote::kSecond, false};

namespace {

using namespace finemote;

constexpr Duration kPeriod = 10 * kMillisecond;

volatile bool tick = false;

Thrusters thrusters(kUnguarded);
Vehicle vehicle(kUnguarded, imu.state, kDepthInPlace, thrusters.commands);

/// One phase a tick: begin temperatures; take them, begin pressures; take those.
class Pressures {
 public:
  void handle() {
    using Kind = PressureSensor::Kind;
    switch (phase_) {
      case 0:
        for (PressureSensor& sensor : sensors) begin(sensor, Kind::temperature);
        break;
      case 1:
        for (PressureSensor& sensor : sensors) {
          sensor.select();
          sensor.set_temperature(sensor.result());
        }
        for (PressureSensor& sensor : sensors) begin(sensor, Kind::pressure);
        break;
      default:
        for_each_below<kSensors>([](auto i) {
          const Update<kFirstSensor + i> stage;
          sensors[i].select();
          sensors[i].set_pressure(sensors[i].result());
          sensors[i].compute();
        });
        break;
    }
    phase_ = phase_ == 2 ? 0 : phase_ + 1;
  }

 private:
  static void begin(PressureSensor& sensor, PressureSensor::Kind kind) {
    sensor.select();
    sensor.begin(kind);
  }

  unsigned phase_ = 0;
} pressures;

void handle_imu() {
  const Update<kImu> stage;
  imu.update();
}

/// Control, and the outputs channel by channel.
void handle_thrusters() {
  vehicle.update();
  vehicle.handle();
  pulses.select();
  for_each_below<kThrusters>([](auto i) {
    const Handle<kFirstThruster + i> stage;
    thrusters.each[i].handle();
    pulses.write_registers(i);
  });
}

void wait_for_tick() {
  const Idle idle;
  while (!tick) {}
  tick = false;
}

}  // namespace

void run() {
  unsigned ticks = 0;
  for (;;) {
    wait_for_tick();
    handle_imu();
    pressures.handle();
    handle_thrusters();
    if (kIsLoaded && ++ticks % (kPayloadPeriod / kPeriod) == 0) run_payload();
  }
}

}  // namespace baseline

extern "C" void finemote_line_48() {
  baseline::tick = true;
  finemote::drain_stores();
}

constexpr finemote::Bucket kTick[] = {{finemote_line_48, baseline::kPeriod, 48, 4, 3}};
extern "C" constexpr finemote::Schedule finemote_schedule =
    baseline::tick_alone("public_polled", kTick, baseline::start_robot_parts);
