// XML to robot: reads the `<finemote>` blocks of a robot and resolves everything in them.
#pragma once

#include <optional>
#include <string>

#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"
#include "generator/units/duration.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

struct ModelOptions {
  std::string board;  ///< instead of the board the robot names (`--board`); empty: the robot's own
  std::string code;   ///< instead of the board's param `code`; empty: that one
  Duration assumed_wcet = microseconds(50);  ///< per stage, for devices that declare none and whose type has no default
  std::string source;                        ///< how outputs call the input; empty: as messages do
  bool from_xacro =
      false;  ///< the text was expanded: a `xacro:` tag that is left is not the user's mistake of file type
};

/// Builds the robot of a document. All mistakes are reported, each once, none that only follows from another; when
/// there is one, there is no robot. Positions are those of the nodes, so an expanded document reports through its
/// expansion chain. Reports FM1002, FM2001 to FM2010, FM3001 to FM3083, and FM31xx for the descriptors it reads.
std::optional<Robot> build_model(const xml::Document& document, Library& library, const ModelOptions& options,
                                 Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
