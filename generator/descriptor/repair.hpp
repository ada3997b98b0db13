// A device descriptor with mistakes to one that can be read on: the robot is still judged by what is right in it.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/schema_check.hpp"

namespace finemote::gen {

/// Puts right what was surely meant, makes params nobody can judge take any text, and drops what only later stages use.
/// The mistakes themselves were reported. Returns false where nothing useful is left: bus, interfaces, roles or uses
/// that cannot be read.
bool repair_device(Json& value, const std::vector<SchemaMistake>& mistakes, const std::string& name);

/// Drops what a type whose descriptor has mistakes requires: values that a robot gives are still checked, missing ones
/// are not reported.
void relax(DeviceType& type);

}  // namespace finemote::gen
