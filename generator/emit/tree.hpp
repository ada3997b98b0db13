// The two files of a device tree: its objects, and its sequences of stages.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/emit/bounds.hpp"
#include "generator/emit/constants.hpp"
#include "generator/emit/names.hpp"

namespace finemote::gen {

/// Template data of trees/<root>.hpp.
Data tree_header(const Plan& plan, const Tree& tree, const std::vector<Constant>& constants,
                 const ProvenBounds& bounds);

/// Template data of trees/<root>.cpp.
Data tree_source(const Plan& plan, const Tree& tree);

/// The buckets this tree has devices in, shortest period first, as indices into Schedule::buckets.
std::vector<std::size_t> buckets_of(const Plan& plan, const Tree& tree);

}  // namespace finemote::gen
