// As a competent engineer would poll: one loop and a timer's flags, waits that end, one transfer for all pulses,
// sensors read every period without a wait for their conversions, outputs that look at the age of what they obey.
#include "i2c_master.hpp"
#include "marks.hpp"
#include "robot.hpp"
#include "start.hpp"

namespace baseline {

const I2cPolicy i2c_policy{200 * finemote::kMicrosecond, 200 * finemote::kMicrosecond, true};

namespace {

using namespace finemote;

constexpr Duration kTick = 5 * kMillisecond, kPeriod = 10 * kMillisecond;

volatile std::uint32_t ticks = 0;

Thrusters thrusters(kGuarded);
Vehicle vehicle(kGuarded, imu.state, kDepthInPlace, thrusters.commands);

void handle_imu() {
  const Update<kImu> stage;
  imu.update();
}

void handle_pressures() {
  for_each_below<kSensors>([](auto i) {
    const Update<kFirstSensor + i> stage;
    sensors[i].turn();
  });
}

void handle_thrusters() {
  vehicle.update();
  vehicle.handle();
  for_each_below<kThrusters>([](auto i) {
    const Handle<kFirstThruster + i> stage;
    thrusters.each[i].handle();
  });
  const MarkedWork<Work::flush_expander> marked;
  if (pulses.select()) pulses.write_all();
}

/// @return  the number of the tick; one that was missed is left out
std::uint32_t wait_for_tick(std::uint32_t last) {
  const Idle idle;
  while (ticks == last) {}
  return ticks;
}

}  // namespace

void run() {
  constexpr std::uint32_t kEvery = kPeriod / kTick;
  std::uint32_t served = 0;
  for (std::uint32_t last = 0;;) {
    last = wait_for_tick(last);
    handle_imu();
    if (last % kEvery != 1) continue;
    handle_pressures();
    handle_thrusters();
    if (kIsLoaded && ++served % (kPayloadPeriod / kPeriod) == 0) run_payload();
  }
}

}  // namespace baseline

extern "C" void finemote_line_48() {
  baseline::ticks = baseline::ticks + 1;
  finemote::drain_stores();
}

constexpr finemote::Bucket kBuckets[] = {{finemote_line_48, baseline::kTick, 48, 4, 3}};
extern "C" constexpr finemote::Schedule finemote_schedule =
    baseline::tick_alone("competent_polled", kBuckets, baseline::start_robot_parts);
