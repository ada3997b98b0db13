// Keeps a command from writing over what it reads, from writing one file twice, and from working for a file that cannot
// be written.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A file that a command is about to write.
struct PlannedFile {
  std::string path;
  std::string option;  ///< the words of the command line that ask for it: `-o`, `--depfile`
};

/// Finds outputs that are one file with an input or with another output. Files are told apart by what the system holds,
/// not by their names: a file has many, through links, `..` and the letter case of some file systems. Pipes and devices
/// may be named as often as one likes.
///
/// Reports FM5013 for each output that is a text of `sources` (standard input counts when it is a file) or one of
/// `others`, FM5014 for each that is an earlier one or standard output.
/// @param others  files that are read, and are no text of `sources`
/// @return  whether all may be written
bool check_outputs(const std::vector<PlannedFile>& outputs, Sources& sources, Diagnostics& diagnostics,
                   const std::vector<std::string>& others = {});

/// The same of files that a command ends with, and finds those that could not be written when the work for them is
/// done: no folder is made for them. Reports FM5002 for each, with the system's reason.
/// @param results  those with an empty path are not asked for
/// @param others   as for check_outputs
/// @param made     a folder that the command makes, with others in it: files below it are not looked at; empty: none
/// @return  whether all may be written, as far as that shows before
bool check_results(std::vector<PlannedFile> results, Sources& sources, Diagnostics& diagnostics,
                   const std::vector<std::string>& others = {}, const std::string& made = {});

}  // namespace finemote::gen
