// FinsROV's devices as all four baselines have them: the runtime's own classes where nothing of them waits, so that the
// control law, its gains, the parsers and the mixing are the same object code as in the generated firmware.
//
// Gains: FinsRov states them in seconds and measures the time between its steps, so one set of gains holds at every
// period. The public firmware states its own in steps of 1/150 s; what they are in seconds is in README.md.
#pragma once

#include <utility>

#include "constants.hpp"
#include "finemote/devices/finsrov.hpp"
#include "finemote/devices/h30_imu.hpp"
#include "finemote/devices/pwm_esc.hpp"
#include "finemote/stage.hpp"
#include "finemote/uart.hpp"
#include "pressure.hpp"
#include "pulse_board.hpp"

namespace baseline {

constexpr unsigned kSensors = 4;

/// What a firmware does with old data, which the devices' figures say.
struct Ages {
  finemote::Duration command;  ///< of what a thruster still obeys
  finemote::Duration orders;   ///< after which motion ordered by the operator ends
};
/// As generated.
constexpr Ages kGuarded{finemote::PwmEsc::Config{}.max_age, finemote::FinsRov::Config{}.host_max_age};
/// Nothing is ever too old.
constexpr Ages kUnguarded{finemote::kSecond * 1'000'000, finemote::kSecond * 1'000'000};

/// Numbers of the stages, which the marks carry: twice the place of the device in the order of `finemote tree`, and one
/// more for handle(). `tests/experiment/` holds them against the generated firmware.
constexpr std::uint16_t kImu = 0, kFirstSensor = 1, kFirstThruster = 5, kRov = 13;
template <unsigned device>
using Update = finemote::Stage<2 * device>;
template <unsigned device>
using Handle = finemote::Stage<2 * device + 1>;

extern finemote::Uart imu_uart, tether;  // as generated
extern finemote::H30Imu imu;
extern PressureSensor sensors[kSensors];
extern PulseBoard pulses;
/// The sensors' own states, for a Vehicle that reads them in place.
inline constexpr const finemote::PressureState* kDepthInPlace[] = {&sensors[0].state, &sensors[1].state,
                                                                   &sensors[2].state, &sensors[3].state};

/// Starts buses and parts, with neutral pulses first. Context: start.
void start_robot_parts();

/// Speed controllers on the board of pulses, as FinsROV's URDF has them.
class Thrusters {
 public:
  constexpr explicit Thrusters(const Ages& ages)
      : each{{config(ages, false), {pulses, 0}}, {config(ages, true), {pulses, 1}}, {config(ages, false), {pulses, 2}},
             {config(ages, false), {pulses, 3}}, {config(ages, true), {pulses, 4}}, {config(ages, true), {pulses, 5}},
             {config(ages, false), {pulses, 6}}, {config(ages, true), {pulses, 7}}} {}

  finemote::PwmEsc each[kThrusters];
  finemote::ThrusterCommand* const commands[kThrusters] = {&each[0].command, &each[1].command, &each[2].command,
                                                           &each[3].command, &each[4].command, &each[5].command,
                                                           &each[6].command, &each[7].command};

 private:
  static constexpr finemote::PwmEsc::Config config(const Ages& ages, bool reverse) {
    finemote::PwmEsc::Config config{};
    config.max_age = ages.command;
    config.reverse = reverse;
    return config;
  }
};

/// The root of the robot, and what it sees of the others.
class Vehicle {
 public:
  /// @param imu, depth  states that it reads
  /// @param commands    what it writes, for each thruster
  constexpr Vehicle(const Ages& ages, const finemote::ImuState& imu,
                    const finemote::PressureState* const (&depth)[kSensors],
                    finemote::ThrusterCommand* const (&commands)[kThrusters])
      : depth_{{*depth[0]}, {*depth[1]}, {*depth[2]}, {*depth[3]}},
        thrusters_{{kUnknown, *commands[0]}, {kUnknown, *commands[1]}, {kUnknown, *commands[2]},
                   {kUnknown, *commands[3]}, {kUnknown, *commands[4]}, {kUnknown, *commands[5]},
                   {kUnknown, *commands[6]}, {kUnknown, *commands[7]}},
        rov_{config(ages), FinsROV::constants::rov_allocation, &tether, {imu}, depth_, thrusters_} {}

  void update() {
    const Update<kRov> stage;
    rov_.update();
  }
  void handle() {
    const Handle<kRov> stage;
    rov_.handle();
  }

 private:
  static constexpr finemote::FinsRov::Config config(const Ages& ages) {
    finemote::FinsRov::Config config{};
    config.host_max_age = ages.orders;
    return config;
  }
  static constexpr finemote::ThrusterState kUnknown{};  ///< nobody looks at it

  const finemote::Port<finemote::Pressure> depth_[kSensors];
  const finemote::Port<finemote::Thruster> thrusters_[kThrusters];
  finemote::FinsRov rov_;
};

/// Work of a payload beside the robot's own, where the firmware is built with BASELINE_LOADED: as the sim_load of
/// loaded.urdf.xacro, whose update() and handle() take a millisecond each, every 20 ms.
constexpr finemote::Duration kPayloadPeriod = 20 * finemote::kMillisecond;
inline void run_payload() {
  finemote::busy(finemote::kMillisecond);
  finemote::busy(finemote::kMillisecond);
}
#ifdef BASELINE_LOADED
constexpr bool kIsLoaded = true;
#else
constexpr bool kIsLoaded = false;
#endif

/// Calls `body` with the numbers 0 to count - 1 as constants.
template <class Body, std::size_t... i>
[[gnu::always_inline]] inline void for_each_of(Body body, std::index_sequence<i...>) {
  (body(std::integral_constant<unsigned, i>{}), ...);
}
template <unsigned count, class Body>
[[gnu::always_inline]] inline void for_each_below(Body body) {
  for_each_of(body, std::make_index_sequence<count>{});
}

}  // namespace baseline
