// How a device reaches a bus, a channel of it or a pin: what templates/argument.mustache names.
#pragma once

#include <optional>

#include "generator/emit/scope.hpp"

namespace finemote::gen {

/// An argument of a constructor: `kind` is its section in templates/argument.mustache, without `is_`.
Data argument_of_kind(const std::string& kind);

/// The argument for what a device sits on; none for a device on a virtual bus.
std::optional<Data> bus_argument(const Plan& plan, const Scope& scope, const Device& device);

/// The argument for what a device may or must use, `/*line*/ ...`: a null pointer where it does not. None for a virtual
/// bus.
std::optional<Data> use_argument(const Plan& plan, const Scope& scope, const Device& device, const UseSpec& spec);

/// What stands in `ports` for the optional endpoints of a device that are values: a pointer needs something to point
/// to.
Data endpoint_objects(const Plan& plan, const Scope& scope, const Device& device);

}  // namespace finemote::gen
