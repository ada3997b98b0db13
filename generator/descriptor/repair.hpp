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

/// A type whose descriptor has mistakes asks for nothing any more: what a robot gives it is judged, what it leaves out
/// is not.
void relax(DeviceType& type);

}  // namespace finemote::gen
