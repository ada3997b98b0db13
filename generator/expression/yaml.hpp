// YAML files to values, by the rules of YAML 1.1 that ROS tools follow.
#pragma once

#include <string>

#include "generator/diagnostic/source.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// The one document of a file; None when there is nothing in it. Scalars are typed as in YAML 1.1: yes/no/on/off,
/// 010 is 8, 1:30 is 90, 1e3 is a text; merge keys, anchors, and the tags !degrees !radians !meters !millimeters
/// !foot !inches, whose text is an expression over the built-ins and whose value is in radians or metres. Fails at the
/// place of the mistake.
Value read_yaml(Runtime& runtime, const SourceFile& file);

/// A plain scalar by the rules of YAML 1.1.
Value yaml_scalar(const std::string& text);

}  // namespace finemote::gen::expression
