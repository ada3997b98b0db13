// A task for each device: they give each other copies of what they know, and share the bus by a mutex. What needs
// attention sooner is more urgent: the attitude, then the sensors, the vehicle, and the thrusters.
#include "i2c_master.hpp"
#include "tasks.hpp"

namespace baseline {

const I2cPolicy i2c_policy{200 * finemote::kMicrosecond, 2 * finemote::kMillisecond, true};

namespace {

using namespace finemote;

constexpr std::uint8_t kImuPriority = 15, kFirstSensorPriority = 14, kRovPriority = 10, kFirstThrusterPriority = 9;

Mutex bus;

Shared<ImuState> attitude;
Shared<PressureState> depth[kSensors];
Shared<ThrusterCommand> orders[kThrusters];

// What the vehicle's task sees of the others.
ImuState attitude_seen;
PressureState depth_seen[kSensors];
ThrusterCommand decided[kThrusters];
constexpr const PressureState* kDepthSeen[] = {&depth_seen[0], &depth_seen[1], &depth_seen[2], &depth_seen[3]};
constexpr ThrusterCommand* kDecided[] = {&decided[0], &decided[1], &decided[2], &decided[3],
                                         &decided[4], &decided[5], &decided[6], &decided[7]};

Thrusters thrusters(kGuarded);
Vehicle vehicle(kGuarded, attitude_seen, kDepthSeen, kDecided);

void take_attitude() {
  const Update<kImu> stage;
  imu.update();
  attitude.put(imu.state);
}

template <unsigned i>
void take_depth() {
  const Update<kFirstSensor + i> stage;
  {
    const Locked locked(bus);
    sensors[i].turn();
  }
  depth[i].put(sensors[i].state);
}

void control() {
  attitude_seen = attitude.get();
  for (unsigned i = 0; i < kSensors; ++i) depth_seen[i] = depth[i].get();
  vehicle.update();
  vehicle.handle();
  for (unsigned i = 0; i < kThrusters; ++i) orders[i].put(decided[i]);
}

template <unsigned i>
void drive() {
  const Handle<kFirstThruster + i> stage;
  thrusters.each[i].command = orders[i].get();
  thrusters.each[i].handle();
  const Locked locked(bus);
  if (pulses.select()) pulses.write_channel(i);
}

Task imu_task, sensor_tasks[kSensors], rov_task, thruster_tasks[kThrusters];
Stack<kStackWords> imu_stack, sensor_stacks[kSensors], rov_stack, thruster_stacks[kThrusters];

}  // namespace

void run() {
  add_task(
      imu_task, [] { every(kImuTicks, take_attitude); }, kImuPriority, imu_stack);
  for_each_below<kSensors>([](auto number) {
    constexpr unsigned i = decltype(number)::value;
    add_task(
        sensor_tasks[i], [] { every(kRobotTicks, take_depth<i>); }, kFirstSensorPriority - i, sensor_stacks[i]);
  });
  add_task(
      rov_task, [] { every(kRobotTicks, control); }, kRovPriority, rov_stack);
  for_each_below<kThrusters>([](auto number) {
    constexpr unsigned i = decltype(number)::value;
    add_task(
        thruster_tasks[i], [] { every(kRobotTicks, drive<i>); }, kFirstThrusterPriority - i, thruster_stacks[i]);
  });
  add_payload();
  start_kernel();
}

}  // namespace baseline
