// Names of ROS packages to their folders, without ROS.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/file/access.hpp"

namespace finemote::gen::xacro {

/// What the package in `folder` calls itself; empty when it is none.
std::string package_name(const std::filesystem::path& folder, const files::Access& access);

/// Where packages are looked for, in this order:
///  1. explicit_folders: `--package name=folder`
///  2. ros_package_path: folders searched for package.xml at any depth, as ROS 1 does
///  3. ament_prefixes: `PREFIX/share/NAME`, as ROS 2 does
///  4. the package the entry file lies in: the nearest folder above with a package.xml
class PackagePath {
 public:
  PackagePath() = default;

  /// Takes ROS_PACKAGE_PATH and AMENT_PREFIX_PATH from the environment.
  static PackagePath from_environment();

  void add(std::string name, std::string folder) { explicit_folders_[std::move(name)] = std::move(folder); }
  void add_ros_path(std::string_view colon_separated);
  void add_ament_path(std::string_view colon_separated);
  /// The file whose own package is the last resort.
  void set_entry(std::string file) { entry_ = std::move(file); }

  struct Found {
    std::string folder;
    std::vector<std::string> others;  ///< further folders on the same path that call themselves so
  };
  /// @param access  which package.xml may be read; in a sandbox explicit_folders and the entry's own package count
  [[nodiscard]] std::optional<Found> find(const std::string& name, const files::Access& access) const;

  /// The places looked at, for messages.
  [[nodiscard]] std::vector<std::string> places() const;

 private:
  using Index = std::map<std::string, std::vector<std::string>>;
  [[nodiscard]] const Index& crawled() const;

  std::map<std::string, std::string> explicit_folders_;
  std::vector<std::string> ros_paths_;
  std::vector<std::string> ament_prefixes_;
  std::string entry_;
  mutable std::optional<Index> crawled_;  // of ros_paths_, made at the first question
};

}  // namespace finemote::gen::xacro
