// The constants that device types ask for by geometry kind, as C++ text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/names.hpp"

namespace finemote::gen {

/// One definition in constants.hpp, or, where it names objects, in `ports` of its device's tree.
struct Constant {
  std::size_t device = 0;  ///< whose type asked for it
  std::string name;        ///< `rov_allocation`
  std::string text;        ///< comment and definition
  bool in_tree = false;
};

/// All constants, in schedule order of their devices, then in descriptor order.
/// Every child that geometry is computed of names its joint: the model has seen to that.
std::vector<Constant> make_constants(const Plan& plan);

}  // namespace finemote::gen
