// Turns attitude, depth and the operator's orders into the efforts of FinsROV's eight thrusters.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/control/step_time.hpp"
#include "finemote/devices/finsrov_host.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/interfaces/pressure.hpp"
#include "finemote/interfaces/thruster.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// Root of the vehicle. Frame: x forward, y left, z up; depth grows downwards.
///
/// Depth is one loop on the mean of the pressure sensors. Roll, pitch and (while switched on) yaw are each two: the
/// outer turns an angle error into a rate, the inner the rate error into a moment. All gains are in seconds; the time
/// between two updates is measured. The wrench goes through the allocation to the thrusters.
///
/// It goes on with the last good inputs: what the thrusters get is as old as the oldest of them, and they stop by
/// themselves when that is too old. When the attitude comes back, the heading of then is held. Motion and test orders
/// end `host_max_age` after the last of them came. Off until the host says `ON`.
class FinsRov {
 public:
  static constexpr unsigned kThrusters = 8;
  static constexpr unsigned kSensors = 4;

  struct Config {
    float surface_pressure = 101325;  ///< Pa
    float density = 1000;             ///< kg/m^3
    std::int32_t depth_quorum = 4;    ///< fresh pressure sensors needed
    Duration input_max_age = 100 * kMillisecond;
    Duration host_max_age = 1 * kSecond;
    float depth_kp = 10, depth_ki = 1, depth_kd = 4, depth_limit = 2;
    float roll_kp = 4, roll_ki = 0.2F, roll_rate_limit = 1, roll_rate_kp = 0.15F, roll_limit = 0.3F;
    float pitch_kp = 4, pitch_ki = 0.2F, pitch_rate_limit = 1, pitch_rate_kp = 0.15F, pitch_limit = 0.3F;
    float yaw_kp = 2, yaw_ki = 0.1F, yaw_rate_limit = 1, yaw_rate_kp = 0.3F, yaw_limit = 0.4F;
    float cruise = 0.57F;  ///< surge or sway, efforts of one thruster
    float turn = 0.1F;     ///< moment, efforts of one thruster times metre
    float heave_trim = 0;
  };

  /// @param allocation  effort n = sum over k of allocation[n][k] * wrench[k]; wrench = fx fy fz mx my mz
  /// @param host        line to the operator, or nullptr
  constexpr FinsRov(const Config& config, const float (&allocation)[kThrusters][6], Uart* host, Port<Imu> imu,
                    Ports<Pressure> depth, Ports<Thruster> thrusters)
      : config_(config),
        allocation_(allocation),
        host_(host),
        imu_(imu),
        depth_(depth),
        thrusters_(thrusters),
        surface_{config.surface_pressure, config.surface_pressure, config.surface_pressure, config.surface_pressure} {}

  void update();
  void handle();

  Stamp state;  ///< as old as the oldest of the last good inputs; valid once there was one of each

  /// For tests and telemetry.
  [[nodiscard]] bool holding() const { return mode_ == Mode::kHold; }
  [[nodiscard]] float depth() const { return depth_now_; }            ///< m
  [[nodiscard]] float target_depth() const { return target_depth_; }  ///< m
  [[nodiscard]] const FinsRovHost& host() const { return orders_; }

 private:
  enum class Mode : std::uint8_t { kOff, kTest, kHold };
  struct Wrench {
    float value[6] = {};  ///< fx fy fz mx my mz
  };

  void take_inputs(Time at);
  bool take_orders(Time at);
  void obey(const FinsRovOrder& order, Time at);
  void take_attitude();
  void take_depth(float depth, Time origin);
  void hold();
  void aim(float depth);
  void move(float surge, float sway, float turn);
  void test(const FinsRovOrder& order);
  void set_surface(Time at);
  void report(bool is_asked, Time at);
  [[nodiscard]] Wrench control(Time at);
  void command_thrusters(const Wrench& wrench);
  void command_test(Time at);
  void command_nothing();

  const Config config_;
  const float (&allocation_)[kThrusters][6];
  Uart* const host_;
  const Port<Imu> imu_;
  const Ports<Pressure> depth_;
  const Ports<Thruster> thrusters_;

  FinsRovHost orders_;
  Mode mode_ = Mode::kOff;
  bool heading_on_ = false, reporting_ = false;
  bool attitude_follows_ = false, depth_follows_ = false;  ///< the last update() had one
  bool depth_known_ = false;                               ///< at least once
  ImuState attitude_;                                      ///< the last valid one
  float surface_[kSensors];
  float depth_now_ = 0, depth_rate_ = 0, target_depth_ = 0, target_yaw_ = 0;
  float surge_ = 0, sway_ = 0, turn_ = 0;
  float test_[kThrusters]{};  ///< efforts of the TES command
  Time ordered_ = 0;          ///< the last motion or test order
  Time depth_at_ = 0;         ///< origin of depth_now_
  StepTime step_;
  Time reported_ = 0;
  Pid depth_loop_, roll_loop_, pitch_loop_, yaw_loop_;
};

}  // namespace finemote
