// A DJI speed controller with its motor on a CAN bus: takes its word of a group frame, reports itself 1000 times a
// second.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "emulator/chip/can_line.hpp"
#include "emulator/plants/motor_shaft.hpp"

namespace finemote::emulator {

/// C620 with M3508, C610 with M2006 and GM6020 are this model with their own figures. The current follows its command
/// at once and stays when commands stop coming, as nothing in the user guides promises otherwise.
class DjiMotor {
 public:
  struct Figures {
    std::uint32_t feedback_id = 0x201, command_id = 0x200;
    unsigned word = 0;               ///< 0..3, its place in the command frame
    double full_word = 16384;        ///< command for `full_current`
    double full_current = 20;        ///< A
    double torque_per_ampere = 0.3;  ///< N m at the output
    double gear = 1;                 ///< turns of the rotor per turn of the output
    double zero = 0;                 ///< rad, what the encoder reads where the output is at zero
    double temperature = 30;         ///< degrees Celsius, what its reports say
    Time period = from_ns(1'000'000), phase = 0;
  };

  DjiMotor(World& world, CanLine& line, const Figures& figures, const MotorShaft::Parameters& shaft);

  MotorShaft& shaft() { return shaft_; }
  [[nodiscard]] int command() const { return command_; }
  [[nodiscard]] double current() const { return command_ * figures_.full_current / figures_.full_word; }
  [[nodiscard]] unsigned commands() const { return commands_; }
  /// The first command after the last pause of more than 8 ms; 0 before there was one.
  [[nodiscard]] int resumed_with() const { return resumed_with_; }
  /// Such pauses; the time before the first command is one.
  [[nodiscard]] unsigned pauses() const { return pauses_; }

  /// Told when a command has arrived, and where its bytes come from.
  std::function<void(int word, Tag origin)> on_command;
  /// Asked what the bytes of a report carry that is made now; told when it has arrived. A damaged one is not asked for.
  std::function<Tag()> on_sample;
  std::function<void(Tag sample)> on_report;

  bool silent = false;           ///< sends no reports; still obeys
  unsigned damaged_reports = 0;  ///< the next ones hold an angle no encoder has

 private:
  void tick();
  void hear(const CanFrame& frame);
  void sent(const CanFrame& frame, CanOutcome outcome);
  [[nodiscard]] CanFrame report(Time now);

  World& world_;
  CanLine& line_;
  Figures figures_;
  MotorShaft shaft_;
  int command_ = 0;
  unsigned commands_ = 0, pauses_ = 0;
  int resumed_with_ = 0;
  Time heard_ = 0;
  std::optional<CanFrame> waiting_;
};

}  // namespace finemote::emulator
