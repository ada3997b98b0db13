// The output folder as it is on disk, and the files it should hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/clash.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/manifest.hpp"

namespace finemote::gen {

/// Everything one run would write: the sources, and the manifest that describes them.
struct Output {
  std::vector<OutputFile> files;
  Manifest manifest;
};

/// Hashes the rendered files and the inputs (names beside their bytes) into a manifest.
Output make_output(std::vector<OutputFile> files, std::vector<HashedFile> inputs, const std::string& robot,
                   std::vector<std::string> options = {});

/// Every file of the output, the manifest last, as `option` asks for it to be written below `folder`.
std::vector<PlannedFile> planned_files(const std::string& folder, const Output& output, const std::string& option);

/// The bytes of a file; none when there is no such regular file, or it cannot be read.
std::optional<std::string> read_bytes(const std::string& path);

/// In the name of every file that is not complete yet: `NAME.finemote-tmp-PID`.
inline constexpr const char* kTemporaryMark = ".finemote-tmp";

/// The text without CR: what is left of a difference between two systems' line ends.
std::string without_carriage_returns(std::string text);

/// Whether two names below `root`, which differ by letter case alone, are one file: on a file system that takes both
/// cases for one.
bool is_one_file(const std::filesystem::path& root, const std::string& a, const std::string& b);

/// What an earlier run left in the folder.
struct Folder {
  enum class Memory { none, broken, complete };

  std::filesystem::path root;
  Memory memory = Memory::none;  ///< of the manifest: not there, not usable, usable
  Manifest previous;             ///< empty unless complete; names spelt as those of this run where they are one file
};

/// `folder` in normal form, without a separator at its end.
std::filesystem::path folder_path(const std::string& folder);

/// Whether a folder can be there: reports FM5002 for a symbolic link and what is no folder, FM5006 for what cannot be
/// read.
bool check_root(const std::filesystem::path& root, Diagnostics& diagnostics);

/// What becomes of a folder that belongs to another robot.
struct OtherRobot {
  bool is_replaced = false;
  /// The hint below FM5003.
  std::string way_out =
      "give each robot a folder of its own with -o; if this robot was renamed, give generate --force, which replaces "
      "the files of the old name";
};

/// Looks at the folder, which may not exist. Reports FM5001 (a warning) for a manifest that cannot be used, FM5002 when
/// the folder or a file in it that we would write is a symbolic link or of another kind, FM5003 when it belongs to
/// another robot that is not replaced, FM5006 when the folder or such a file cannot be read; none after an error.
std::optional<Folder> open_folder(const std::string& folder, const Output& output, const OtherRobot& other,
                                  Diagnostics& diagnostics);

}  // namespace finemote::gen
