// The emulator's document of a run to its record.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "generator/run/record.hpp"

namespace finemote::gen {

/// @param document  of a run that came to its end; emulator/program/job.cpp writes it
RunRecord read_record(const nlohmann::ordered_json& document, const Robot& robot, const Forest& forest);

/// What the firmware has counted, also of a run that stopped before.
std::vector<FaultCount> faults_of(const nlohmann::ordered_json& document);

/// The same until a scenario violated an assumption of the bounds, after the bring-up.
std::vector<FaultCount> undisturbed_faults_of(const nlohmann::ordered_json& document);

/// A time of the document.
Duration time_of(const nlohmann::ordered_json& ns);

}  // namespace finemote::gen
