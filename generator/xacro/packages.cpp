#include "generator/xacro/packages.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace finemote::gen::xacro {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 12;  // folders below a package path
constexpr std::size_t kMostFolders = 200'000;

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> folders;
  while (!path.empty()) {
    const auto end = std::min(path.find(':'), path.size());
    if (end > 0) folders.emplace_back(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return folders;
}

/// The content of the first <name> element, without blanks around it; comments are skipped.
std::string name_in(std::string text) {
  for (auto begin = text.find("<!--"); begin != std::string::npos; begin = text.find("<!--")) {
    const auto end = text.find("-->", begin);
    text.erase(begin, end == std::string::npos ? end : end + 3 - begin);
  }
  const auto tag = text.find("<name");
  const auto open = text.find('>', tag == std::string::npos ? text.size() : tag);
  const auto close = text.find("</name>", open == std::string::npos ? text.size() : open);
  if (close == std::string::npos) return {};
  const std::string name = text.substr(open + 1, close - open - 1);
  const auto first = name.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : name.substr(first, name.find_last_not_of(" \t\r\n") - first + 1);
}

bool is_ignored(const fs::path& folder) {
  std::error_code ignored;
  for (const char* mark : {"CATKIN_IGNORE", "AMENT_IGNORE", "COLCON_IGNORE"}) {
    if (fs::exists(folder / mark, ignored)) return true;
  }
  return folder.filename().string().starts_with('.');
}

/// Walks the folders below a path, in order of name; a package holds no other packages.
class Crawler {
 public:
  explicit Crawler(std::map<std::string, std::vector<std::string>>& index) : index_(index) {}

  void crawl(const fs::path& folder, int depth) {
    if (depth > kDeepest || ++visited_ > kMostFolders) return;
    std::error_code ignored;
    if (fs::is_regular_file(folder / "package.xml", ignored)) {
      add(package_name(folder, {}), folder.string());
      return;
    }
    for (const fs::path& inner : folders_in(folder)) {
      if (!is_ignored(inner)) crawl(inner, depth + 1);
    }
  }

 private:
  static std::vector<fs::path> folders_in(const fs::path& folder) {
    std::vector<fs::path> inner;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
      std::error_code ignored;
      if (at->is_directory(ignored)) inner.push_back(at->path());
    }
    std::sort(inner.begin(), inner.end());
    return inner;
  }

  void add(const std::string& name, const std::string& folder) {
    auto& folders = index_[name];
    std::error_code ignored;
    const bool is_known = std::any_of(folders.begin(), folders.end(),
                                      [&](const std::string& f) { return fs::equivalent(f, folder, ignored); });
    if (!is_known) folders.push_back(folder);
  }

  std::map<std::string, std::vector<std::string>>& index_;
  std::size_t visited_ = 0;
};

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// The nearest folder at or above `file` that is the package `name`.
std::optional<std::string> enclosing_package(const std::string& file, const std::string& name,
                                             const files::Access& access) {
  std::error_code failed;
  fs::path folder = fs::absolute(file, failed).parent_path();
  if (file.empty() || failed) return std::nullopt;
  for (;; folder = folder.parent_path()) {
    const std::string found = package_name(folder, access);
    if (found == name) return folder.string();
    if (!found.empty() || folder == folder.parent_path()) return std::nullopt;
  }
}

}  // namespace

std::string package_name(const fs::path& folder, const files::Access& access) {
  constexpr std::size_t largest = 1 << 20;
  auto text = access.read((folder / "package.xml").string(), largest);
  if (!text) return {};
  std::string name = name_in(std::move(*text));
  return name.empty() ? folder.filename().string() : name;
}

PackagePath PackagePath::from_environment() {
  PackagePath path;
  path.add_ros_path(variable("ROS_PACKAGE_PATH"));
  path.add_ament_path(variable("AMENT_PREFIX_PATH"));
  return path;
}

void PackagePath::add_ros_path(std::string_view colon_separated) {
  for (std::string& folder : split_path(colon_separated)) ros_paths_.push_back(std::move(folder));
  crawled_.reset();
}

void PackagePath::add_ament_path(std::string_view colon_separated) {
  for (std::string& folder : split_path(colon_separated)) ament_prefixes_.push_back(std::move(folder));
}

const PackagePath::Index& PackagePath::crawled() const {
  if (!crawled_) {
    crawled_.emplace();
    Crawler crawler(*crawled_);
    for (const std::string& path : ros_paths_) crawler.crawl(path, 0);
  }
  return *crawled_;
}

std::optional<PackagePath::Found> PackagePath::find(const std::string& name, const files::Access& access) const {
  if (const auto given = explicit_folders_.find(name); given != explicit_folders_.end())
    return Found{given->second, {}};
  const Index& index = crawled();
  if (const auto found = index.find(name); found != index.end()) {
    return Found{found->second.front(), {found->second.begin() + 1, found->second.end()}};
  }
  const bool is_plain = !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
  for (const std::string& prefix : ament_prefixes_) {
    std::error_code ignored;
    fs::path folder = fs::path(prefix) / "share" / name;
    if (is_plain && fs::is_directory(folder, ignored)) return Found{folder.string(), {}};
  }
  if (auto own = enclosing_package(entry_, name, access)) return Found{std::move(*own), {}};
  return std::nullopt;
}

std::vector<std::string> PackagePath::places() const {
  std::vector<std::string> all = ros_paths_;
  for (const std::string& prefix : ament_prefixes_) all.push_back(prefix + "/share");
  return all;
}

}  // namespace finemote::gen::xacro
