// Files that cannot be read, as failures of an expansion.
#pragma once

#include <string>

#include "generator/xacro/engine.hpp"
#include "generator/xml/parse.hpp"

namespace finemote::gen::xacro {

struct SystemError {
  int number = 0;    ///< errno; 0 for none
  std::string text;  ///< "No such file or directory"
};

/// Why a file cannot be opened, when the system says so. Fails with FM0008 when the sandbox of `sources` does not let
/// it, and with FM0002 when it is no regular file.
/// @param at  who asked for it
SystemError why_unreadable(const std::string& file, const Sources& sources, const Position& at);

/// Fails with FM0008 at `at`.
[[noreturn]] void fail_outside(const std::string& file, const files::Denial& denial, const Position& at);

/// The checked text of a file; fails as xml::read_source() reports.
/// @param at  who asked for it
const SourceFile* read_text(const std::string& file, Sources& sources, const Position& at);

/// A text that is no XML, in the words of ROS xacro.
/// @param via  how the file was reached; null for the entry
Failure failure_of(const xml::Malformed& malformed, const Expansion* via);

}  // namespace finemote::gen::xacro
