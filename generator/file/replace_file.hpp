// Writes one file all or nothing: beside it first, then in its place.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "generator/file/descriptor_buffer.hpp"

namespace finemote::gen {

/// What exists and is no regular file, and names that stand for an open file: it is written directly.
bool is_special(const std::filesystem::path& path);

/// The file behind symbolic links, which need not be there; the path itself where there is none.
std::filesystem::path behind_links(std::filesystem::path path);

/// A file in the making. Until commit() the old file is as it was; what is not committed vanishes with the object.
///
/// A symbolic link stays, and what it leads to is replaced. The mode of an existing file is kept. What is no regular
/// file (a pipe, /dev/null, /dev/stdout) is written directly.
class ReplacedFile {
 public:
  explicit ReplacedFile(const std::string& path);
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;
  ~ReplacedFile();

  /// Where to write; writing after a failure does nothing.
  std::ostream& stream() { return stream_; }
  /// Puts the file in its place. Returns the system's reason where that, or any write before, failed: the old file is
  /// then as it was.
  std::optional<std::string> commit();

 private:
  void open_beside(const std::filesystem::path& target);
  int close_descriptor();

  std::filesystem::path target_, temporary_;  ///< temporary_ is empty where the target is written directly
  int descriptor_ = -1;
  int error_ = 0;
  DescriptorBuffer buffer_;
  std::ostream stream_;
};

/// Writes `text` as the whole of the file; returns the system's reason where it failed.
std::optional<std::string> replace_file(const std::string& path, std::string_view text);

/// Why replace_file() would fail, as far as that shows before anything is written: the path is a folder, or its own
/// folder is missing or closed. The system's reason; nothing where the file can be begun.
std::optional<std::string> why_not_replaced(const std::string& path);

/// Writes `text` to a file that is not there yet; returns the error number of the system, or 0. A file that could not
/// be completed is removed.
int create_file(const std::filesystem::path& path, std::string_view text);

}  // namespace finemote::gen
