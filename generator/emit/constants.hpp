// The constants that device types ask for by geometry kind, as C++ text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/names.hpp"

namespace finemote::gen {

/// One definition in constants.hpp.
struct Constant {
  std::size_t device = 0;  ///< whose type asked for it
  std::string name;        ///< `rov_allocation`
  std::string text;        ///< comment and definition
};

/// All constants, in schedule order of their devices, then in descriptor order.
/// Reports FM3203 when a child lacks the joint that the geometry needs, FM3204 for a kind this version does not know.
std::vector<Constant> make_constants(const Plan& plan, Diagnostics& diagnostics);

}  // namespace finemote::gen
