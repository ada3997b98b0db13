// A task for each period: the attitude every 5 ms, everything else every 10 ms. Transfers let the other one run.
#include "i2c_master.hpp"
#include "tasks.hpp"

namespace baseline {

const I2cPolicy i2c_policy{200 * finemote::kMicrosecond, 2 * finemote::kMillisecond, true};

namespace {

using namespace finemote;

Shared<ImuState> attitude;
ImuState attitude_seen;

Thrusters thrusters(kGuarded);
Vehicle vehicle(kGuarded, attitude_seen, kDepthInPlace, thrusters.commands);

void take_attitude() {
  const Update<kImu> stage;
  imu.update();
  attitude.put(imu.state);
}

void control() {
  for_each_below<kSensors>([](auto i) {
    const Update<kFirstSensor + i> stage;
    sensors[i].turn();
  });
  attitude_seen = attitude.get();
  vehicle.update();
  vehicle.handle();
  for_each_below<kThrusters>([](auto i) {
    const Handle<kFirstThruster + i> stage;
    thrusters.each[i].handle();
  });
  const MarkedWork<Work::flush_expander> marked;
  if (pulses.select()) pulses.write_all();
}

Task imu_task, robot_task;
Stack<kStackWords> imu_stack, robot_stack;

}  // namespace

void run() {
  add_task(
      imu_task, [] { every(kImuTicks, take_attitude); }, 3, imu_stack);
  add_task(
      robot_task, [] { every(kRobotTicks, control); }, 2, robot_stack);
  add_payload();
  start_kernel();
}

}  // namespace baseline
