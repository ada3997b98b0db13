// Names that scaffolded files need, made of what a user says.
#pragma once

#include <string>

namespace finemote::gen {

/// The name of a project and its robot, of the folder it lies in: letters, digits and `_`, not beginning with a digit,
/// and no name of a target that CMake or the package has already.
std::string project_name(const std::string& folder);

/// Whether a device type or board can be called so: lower-case letters, digits and `_`, a letter first.
bool is_type_name(const std::string& name);

/// `left_wheel` to `LeftWheel`.
std::string camel_case(const std::string& type);

}  // namespace finemote::gen
