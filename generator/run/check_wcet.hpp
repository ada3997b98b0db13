// Holds the execution times the analysis was given against those of a run.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// The execution times that the analysis of the robot uses.
Table<DeviceId, Wcet> analysed_wcets(const Robot& robot, const Forest& forest, const timing::Model& model);

/// Reports (FM6006) every device of which a run of a stage took longer by itself than its WCET says: bounds made from
/// that WCET are not proven.
/// @return  whether there is none
bool check_wcet(const Robot& robot, const Table<DeviceId, Wcet>& wcets, const RunRecord& record,
                Diagnostics& diagnostics);

/// Execution times a run has shown: the longest own time of each stage plus 25 %.
struct MeasuredWcet {
  DeviceId device;
  Duration update, handle;
};

/// Of every device whose execution times are assumed and both of whose stages ran.
std::vector<MeasuredWcet> measured_wcets(const Robot& robot, const RunRecord& record);

/// `<wcet update="22us" handle="1us" source="measured"/>`
std::string wcet_element(const MeasuredWcet& wcet);

}  // namespace finemote::gen
