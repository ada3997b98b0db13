// A CAN line without a chip: what it carries, and a frame that commands motors.
#pragma once

#include <optional>
#include <vector>

#include "emulator/chip/can_line.hpp"

namespace finemote::test {

struct MotorLine {
  MotorLine() {
    line.attach({{}, {}, [this](const emulator::CanFrame& frame) { heard.push_back(frame); }});
    line.attach(
        {[this] { return command; }, [this](const emulator::CanFrame&, emulator::CanOutcome) { command.reset(); }, {}});
  }
  MotorLine(const MotorLine&) = delete;
  MotorLine& operator=(const MotorLine&) = delete;

  emulator::World world;
  emulator::CanLine line{world};
  std::vector<emulator::CanFrame> heard;
  std::optional<emulator::CanFrame> command;  ///< is sent once the line is asked to
};

}  // namespace finemote::test
