// Folders to the files of a library: the shipped ones, and what a user adds to them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/descriptor/file_format.hpp"
#include "generator/descriptor/library.hpp"

namespace finemote::gen {

/// Every `*.json` of a folder, by name; a folder that does not exist has none. `display` stands before the names.
std::vector<LibraryFile> list_folder(const std::filesystem::path& folder, const std::string& display, bool builtin,
                                     const files::Access& access, files::Denial& denial);

/// Adds what a user's folders hold; a name that is already there is an error at the later file, FM3106.
class UserFolders {
 public:
  /// What a folder is searched for; among device types stand descriptors of expanders, among boards chips.
  enum class For { devices, boards };

  UserFolders(Library& library, const std::string& input_dir, Sources& sources, Diagnostics& diagnostics)
      : library_(library), input_dir_(input_dir), sources_(sources), diagnostics_(diagnostics) {}

  /// One that need not exist.
  void add(const std::filesystem::path& folder, For purpose);
  /// Folders as on the command line: they have to exist, or FM0002.
  void add_given(const std::vector<std::string>& folders, For purpose);

 private:
  /// One that does not say what it describes is taken for both: whoever names it is told what is wrong with it.
  void add_descriptor(const LibraryFile& file);
  /// A board, unless it says that it is a chip.
  void add_board(const LibraryFile& file);
  void add_file(const LibraryFile& file, const FileFormat& format, std::vector<LibraryFile>& files);

  Library& library_;
  const std::string& input_dir_;
  Sources& sources_;
  Diagnostics& diagnostics_;
};

}  // namespace finemote::gen
