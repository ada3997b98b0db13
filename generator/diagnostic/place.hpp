// What a position is for people: its text, and where they asked for it.
#pragma once

#include <string>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// `a.xacro:12:5`; `finemote` for a place in no file.
std::string place_text(const Position& at);

/// The same with the file where SourceFile::place() says.
std::string place_for_programs(const Position& at);

/// Where a user asked for the text a place is in: its outermost macro call or include; the place itself at top level.
Position outermost(Position at);

}  // namespace finemote::gen
