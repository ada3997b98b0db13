// The constants that device types ask for by geometry kind, as templates/constant.mustache spells them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/emit/names.hpp"

namespace finemote::gen {

/// One definition in constants.hpp, or, where it names objects, in `ports` of its device's tree.
struct Constant {
  DeviceId device;             ///< whose type asked for it
  std::string name;            ///< `rov_allocation`
  std::optional<Data> fields;  ///< what its template names; none: there is none, the constructor gets a null pointer
  bool in_tree = false;
  std::string header;  ///< of the types it is made of; empty: built-in ones
  [[nodiscard]] bool exists() const { return fields.has_value(); }
};

/// All constants, in schedule order of their devices, then in descriptor order.
/// Every child that geometry is computed of names its joint, and fits: the model has seen to that. Reports FM2016 for
/// one that holds a number which no float holds, and leaves it out.
std::vector<Constant> make_constants(const Plan& plan, Diagnostics& diagnostics);

}  // namespace finemote::gen
