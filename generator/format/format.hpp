// The text of a robot to the same text with every <finemote> element in its canonical layout.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen {

/// One element per line, two blanks deeper than the one it is in; attributes in the order of the grammar, in double
/// quotes, on further lines where they are too many for one of 120 columns; no more than one blank line in a row.
/// Comments keep their words and their places. What stands outside of <finemote> is not touched, nor is an element that
/// holds text beside elements. The text means the same afterwards.
///
/// @param text  well-formed XML, a robot or what xacro makes one from
std::string formatted(std::string_view text);

}  // namespace finemote::gen
