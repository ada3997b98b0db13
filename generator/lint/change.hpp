// What is to be done to one element of a robot's file, to the edits that do it, or to the reason why none may.
#pragma once

#include <string>
#include <vector>

#include "generator/lint/edit.hpp"

namespace finemote::gen {

/// Edits of one file; none, and a reason, where they could change more than they are meant to.
struct Change {
  std::vector<Edit> edits;
  std::string reason;  ///< `it stands in <xacro:if>`
};

/// Puts an element before another one, with the comments directly above it and after it on its line. Both have to be
/// written in the file that the user named, side by side in one element that no xacro element surrounds, and nothing of
/// xacro may stand between them: a property, a condition or a macro could mean something else on the other side.
Change move_before(const Position& element, const Position& target);

/// Takes an element away, with its line where nothing else stands on it. Comments stay. The same place as for a move.
Change remove_element(const Position& element);

}  // namespace finemote::gen
