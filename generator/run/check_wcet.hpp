// Holds the execution times the analysis was given against those of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// Warns (FM6006) of every device of which even the shortest run of a stage took longer than its WCET and
/// `stage_cost`, what the model adds for dispatch and trace: bounds made from that WCET are not proven. Time of
/// stages that interrupted it does not count; interrupts of buses do, therefore the shortest run is asked.
void check_wcet(const Robot& robot, const RunRecord& record, Duration stage_cost, Diagnostics& diagnostics);

/// Execution times a run has shown: the longest run of each stage, interrupts included, and a quarter.
struct MeasuredWcet {
  DeviceId device;
  Duration update, handle;
};

/// Of every device whose execution times are assumed and both of whose stages ran.
std::vector<MeasuredWcet> measured_wcets(const Robot& robot, const RunRecord& record);

/// `<wcet update="22us" handle="1us" source="measured"/>`
std::string wcet_element(const MeasuredWcet& wcet);

}  // namespace finemote::gen
