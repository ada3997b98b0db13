// Replaces many files of a folder at once: all of them, or none.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace finemote::gen {

/// First stage() every new file, then put(), take_away() and set_aside() them, then keep(). What was done before is
/// undone by the destructor unless keep() was reached. Every function throws filesystem_error with the file and the
/// reason.
///
/// A process that is killed leaves temporary files: clean_up() of a later run removes them.
class Replacement {
 public:
  explicit Replacement(std::filesystem::path root);
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement();

  /// Removes what killed runs left of files with these names. Only with the lock of the folder.
  void clean_up(const std::vector<std::string>& names);
  /// Writes a file under its temporary name, and makes the folders it needs.
  void stage(const std::string& name, const std::string& text);
  /// Renames a staged file into its place.
  void put(const std::string& name);
  /// Removes a file.
  void take_away(const std::string& name);
  /// Renames a file of the user's.
  void set_aside(const std::string& name, const std::string& to);
  /// All is done: nothing will be undone.
  void keep();

 private:
  struct Done {
    std::filesystem::path at;      ///< what was changed
    std::filesystem::path before;  ///< where it can be had again; empty: nothing was there
  };

  [[nodiscard]] std::filesystem::path temporary(const std::string& name) const;
  [[nodiscard]] std::filesystem::path backup(const std::string& name) const;

  std::filesystem::path root_;
  std::vector<std::filesystem::path> staged_, backups_, created_;
  std::vector<Done> done_;
};

}  // namespace finemote::gen
