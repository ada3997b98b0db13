// Which files of the system a run may read: every input file, listing of a folder and wild card passes through here.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace finemote::gen::files {

/// An open file; closes it.
class Handle {
 public:
  explicit Handle(int descriptor) : descriptor_(descriptor) {}
  Handle(Handle&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle();

  [[nodiscard]] int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// Why a file is not read.
struct Denial {
  int error = 0;            ///< errno of the system; 0 when the policy says no
  std::string reason = {};  ///< for messages: "it is a folder", "no such file or directory", "it lies outside ..."
  bool is_outside = false;  ///< the sandbox refuses it
};

/// Whose wish it is to open a file. Only the user may name an open descriptor of the process (`<(command)` of a shell).
enum class Asked { by_user, by_file };

/// The policy. A value without state of the process: made once from the command line, handed down with the sources.
///
/// Ordinary: any regular file; pipes, sockets and devices are refused, so that no file can make the tool wait.
/// Sandbox: regular files below given folders, no hidden ones (`.git` holds credentials); the real place of a file
/// counts, however its name gets there (`..`, absolute names, symbolic links). The file is opened from the folder down,
/// one component after the other and through no link, so that nobody can exchange one between the check and the use.
class Access {
 public:
  Access() = default;
  /// @param folders  what may be read; one that does not exist allows nothing
  static Access sandbox(const std::vector<std::string>& folders);

  [[nodiscard]] bool is_sandbox() const { return is_sandbox_; }

  /// Opens a regular file for reading. `-1` and a filled `denial` when it may not, or cannot.
  Handle open(const std::string& path, Asked asked, Denial& denial) const;
  /// Why open() would refuse a file; nothing when it would not.
  [[nodiscard]] std::optional<Denial> why_not(const std::string& path) const;
  /// Names in a folder, in byte order; none when it does not exist. A filled `denial` when it may not be read.
  std::vector<std::string> list(const std::string& folder, Denial& denial) const;
  /// Files that match a pattern of the shell, in byte order. A filled `denial` when the pattern begins outside; further
  /// on, folders outside count as empty. Counts `folders_left` down by the folders it lists: `*/../*/..` would go
  /// through the same ones without end. At 0 it gives up, and the answer is not complete.
  std::vector<std::string> match(const std::string& pattern, std::size_t& folders_left, Denial& denial) const;
  /// Whether a folder is there, and may be looked into.
  [[nodiscard]] bool holds_folder(const std::string& folder) const;
  /// The whole file; nothing when it may not or cannot be read, or is larger than `most` bytes.
  [[nodiscard]] std::optional<std::string> read(const std::string& path, std::size_t most) const;

 private:
  /// A path as a folder that may be read and a way down from it without links.
  struct Inside {
    std::string folder;
    std::vector<std::string> way;
  };
  [[nodiscard]] std::optional<Inside> locate(const std::string& path) const;
  struct Matching;
  [[nodiscard]] bool is_there(const std::string& path) const;
  void add_matches(const std::string& begun, std::size_t next, Matching& matching) const;
  [[nodiscard]] int open_inside(const std::string& path, int flags, Denial& denial) const;
  [[nodiscard]] int open_any(const std::string& path, int flags, Denial& denial) const;

  bool is_sandbox_ = false;
  std::vector<std::string> folders_;  // canonical
};

}  // namespace finemote::gen::files
