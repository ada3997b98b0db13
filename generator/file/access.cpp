#include "generator/file/access.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <filesystem>
#include <string_view>

#include "generator/file/system_reason.hpp"
#include "generator/file/wild_card.hpp"

namespace finemote::gen::files {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOutside = "it lies outside the sandbox";
constexpr int kReading = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

Denial system_denial(int error) { return {error, system_reason(error), false}; }

Denial outside(const char* reason = kOutside) { return {0, reason, true}; }

/// What is no regular file, in words.
std::string kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "it is a pipe, not a regular file";
  if (S_ISSOCK(mode)) return "it is a socket, not a regular file";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "it is a device, not a regular file";
  return "it is not a regular file";
}

/// Denies what is no regular file; true when it is one.
bool is_regular(const struct stat& status, Denial& denial) {
  if (S_ISREG(status.st_mode)) return true;
  denial =
      S_ISDIR(status.st_mode) ? Denial{EISDIR, "it is a folder", false} : Denial{0, kind_of(status.st_mode), false};
  return false;
}

/// A descriptor of this process, as shells give it for `<(command)`.
bool is_own_descriptor(std::string_view path) {
  return path == "/dev/stdin" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
}

bool is_below(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

std::vector<std::string> components(std::string_view way) {
  std::vector<std::string> parts;
  while (!way.empty()) {
    const auto end = std::min(way.find('/'), way.size());
    if (end > 0) parts.emplace_back(way.substr(0, end));
    way.remove_prefix(std::min(end + 1, way.size()));
  }
  return parts;
}

struct CloseFolder {
  DIR* folder;
  ~CloseFolder() { ::closedir(folder); }
};

}  // namespace

Handle::~Handle() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Access Access::sandbox(const std::vector<std::string>& folders) {
  Access access;
  access.is_sandbox_ = true;
  for (const std::string& folder : folders) {
    std::error_code failed;
    const fs::path real = fs::canonical(folder.empty() ? "." : folder, failed);
    if (!failed) access.folders_.push_back(real.string());
  }
  return access;
}

std::optional<Access::Inside> Access::locate(const std::string& path) const {
  std::error_code failed;
  const fs::path absolute = fs::absolute(path, failed);
  const std::string real = failed ? std::string() : fs::weakly_canonical(absolute, failed).string();
  if (failed) return std::nullopt;
  for (const std::string& folder : folders_) {
    if (!is_below(real, folder)) continue;
    Inside inside{folder, components(std::string_view(real).substr(folder.size()))};
    const auto is_hidden = [](const std::string& name) { return name.front() == '.'; };
    if (std::none_of(inside.way.begin(), inside.way.end(), is_hidden)) return inside;
  }
  return std::nullopt;
}

/// Opens a real path step by step. A link on the way was made after the path was resolved, or leads nowhere.
int Access::open_inside(const std::string& path, int flags, Denial& denial) const {
  const auto inside = locate(path);
  if (!inside) return denial = outside(), -1;
  Handle at(::open(inside->folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (std::size_t i = 0; at && i < inside->way.size(); ++i) {
    const bool is_last = i + 1 == inside->way.size();
    struct stat status {};
    if (::fstatat(at.get(), inside->way[i].c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) break;
    if (S_ISLNK(status.st_mode)) return denial = outside("it is a symbolic link that leads nowhere or outside"), -1;
    const bool wants_file = is_last && (flags & O_DIRECTORY) == 0;
    if (wants_file && !is_regular(status, denial)) return -1;
    const int how = is_last ? flags | O_NOFOLLOW : O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    at = Handle(::openat(at.get(), inside->way[i].c_str(), how));
    if (at && is_last) {
      const int copy = ::fcntl(at.get(), F_DUPFD_CLOEXEC, 0);
      if (copy < 0) denial = system_denial(errno);
      return copy;
    }
  }
  if (at && inside->way.empty() && (flags & O_DIRECTORY) != 0) return ::open(inside->folder.c_str(), flags);
  denial = inside->way.empty() ? Denial{EISDIR, "it is a folder", false} : system_denial(errno);
  return -1;
}

int Access::open_any(const std::string& path, int flags, Denial& denial) const {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return denial = system_denial(errno), -1;
  if ((flags & O_DIRECTORY) == 0 && !is_regular(status, denial)) return -1;
  const int descriptor = ::open(path.c_str(), flags);
  if (descriptor < 0) denial = system_denial(errno);
  return descriptor;
}

Handle Access::open(const std::string& path, Asked asked, Denial& denial) const {
  if (is_sandbox_) return Handle(open_inside(path, kReading, denial));
  if (asked == Asked::by_user && is_own_descriptor(path)) {
    Handle own(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!own) denial = system_denial(errno);
    return own;
  }
  Handle file(open_any(path, kReading, denial));
  struct stat status {};  // once more, of what was opened
  if (file && (::fstat(file.get(), &status) != 0 || !is_regular(status, denial))) return Handle(-1);
  return file;
}

std::optional<Denial> Access::why_not(const std::string& path) const {
  Denial denial;
  if (open(path, Asked::by_file, denial)) return std::nullopt;
  return denial;
}

std::vector<std::string> Access::list(const std::string& folder, Denial& denial) const {
  constexpr int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
  Denial reason;
  const int descriptor = is_sandbox_ ? open_inside(folder, flags, reason) : open_any(folder, flags, reason);
  if (descriptor < 0 && reason.error != ENOENT && reason.error != ENOTDIR) denial = reason;
  DIR* opened = descriptor < 0 ? nullptr : ::fdopendir(descriptor);
  if (opened == nullptr) return {};
  const CloseFolder guard{opened};
  std::vector<std::string> names;
  while (const dirent* entry = ::readdir(opened)) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A pattern on its way through the folders of the sandbox.
struct Access::Matching {
  std::vector<std::string> parts;
  std::size_t& folders_left;
  std::vector<std::string> files = {};
};

/// Whether a path leads to something that a pattern can stand for. In the sandbox nobody learns what is outside.
bool Access::is_there(const std::string& path) const {
  std::error_code failed;
  if (!is_sandbox_) return fs::exists(fs::symlink_status(path, failed));
  const auto denial = why_not(path);
  return !denial || (!denial->is_outside && denial->error != ENOENT && denial->error != ENOTDIR);
}

/// Adds what `begun` and the components from `next` on match, as glob() does it, but bounded, and it sees nothing
/// outside.
void Access::add_matches(const std::string& begun, std::size_t next, Matching& matching) const {
  const auto& parts = matching.parts;
  if (begun.size() >= PATH_MAX) return;  // the system opens no longer one
  if (next == parts.size()) {
    if (is_there(begun)) matching.files.push_back(begun);
    return;
  }
  const auto joined = [&begun](const std::string& name) {
    return begun.empty() || begun == "/" ? begun + name : begun + "/" + name;
  };
  if (!is_wild(parts[next])) return add_matches(joined(parts[next]), next + 1, matching);
  if (matching.folders_left == 0) return;
  --matching.folders_left;
  Denial unseen;
  for (const std::string& name : list(begun.empty() ? "." : begun, unseen)) {
    if (matches(parts[next], name)) add_matches(joined(name), next + 1, matching);
  }
}

std::vector<std::string> Access::match(const std::string& pattern, std::size_t& folders_left, Denial& denial) const {
  const auto slash = pattern.rfind('/', pattern.find_first_of("*?["));
  const std::string begin = slash == std::string::npos ? "." : pattern.substr(0, slash + 1);
  if (is_sandbox_ && !locate(begin)) return denial = outside(), std::vector<std::string>();
  Matching matching{components(pattern), folders_left};
  add_matches(pattern.starts_with('/') ? "/" : "", 0, matching);
  std::sort(matching.files.begin(), matching.files.end());
  return std::move(matching.files);
}

bool Access::holds_folder(const std::string& folder) const {
  std::error_code failed;
  return (!is_sandbox_ || locate(folder)) && fs::is_directory(folder, failed);
}

std::optional<std::string> Access::read(const std::string& path, std::size_t most) const {
  Denial denial;
  const Handle file = open(path, Asked::by_file, denial);
  std::string text;
  for (ssize_t count = file ? 1 : -1; count != 0;) {
    if (count < 0 || text.size() > most) return std::nullopt;
    constexpr std::size_t block = 1 << 16;
    const std::size_t size = text.size();
    text.resize(size + block);
    count = ::read(file.get(), text.data() + size, block);
    text.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  return text;
}

}  // namespace finemote::gen::files
