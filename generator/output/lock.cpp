#include "generator/output/lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include "generator/diagnostic/code_output.hpp"
#include "generator/file/system_reason.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto kLongestWait = 5s;
constexpr auto kPause = 10ms;

}  // namespace

std::vector<fs::path> create_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path path = folder; !path.empty() && !fs::exists(path, ignored); path = path.parent_path())
    missing.push_back(path);
  std::reverse(missing.begin(), missing.end());
  std::vector<fs::path> created;
  for (const fs::path& path : missing) {
    std::error_code failed;
    if (fs::create_directory(path, failed)) created.push_back(path);
    if (!failed) continue;
    remove_folders(created);
    throw fs::filesystem_error("cannot create", path, failed);
  }
  return created;
}

void remove_folders(const std::vector<fs::path>& created) {
  for (auto path = created.rbegin(); path != created.rend(); ++path) ::rmdir(path->c_str());
}

FolderLock::FolderLock(const fs::path& folder, Use use, Diagnostics& diagnostics) : use_(use) {
  // Who waited may hold the lock of a folder that was removed meanwhile: then once more.
  while (open(folder, diagnostics)) {
    if (!wait(use == Use::write ? LOCK_EX : LOCK_SH)) {
      diagnostics
          .error(code::folder_in_use, {},
                 fmt::format("another finemote has been writing to '{}' for {} s", folder.generic_string(),
                             std::chrono::seconds(kLongestWait).count()))
          .hint("wait until it has ended, and run the command again");
      return;
    }
    if (is_still(folder)) return;
    close();
  }
}

FolderLock::~FolderLock() { close(); }

void FolderLock::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

void FolderLock::remove_created() {
  remove_folders(created_);
  created_.clear();
}

/// False where there is nothing to lock: no folder, none that can be opened (whoever reads it says why), or an error.
bool FolderLock::open(const fs::path& folder, Diagnostics& diagnostics) {
  if (use_ == Use::write) {
    try {
      for (fs::path& path : create_folders(folder)) created_.push_back(std::move(path));
    } catch (const fs::filesystem_error& error) {
      diagnostics.error(code::output_not_writable, {},
                        fmt::format("cannot create folder '{}': {}", error.path1().generic_string(),
                                    system_reason(error.code().value())));
      return false;
    }
  }
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return descriptor_ >= 0;
}

/// True with the lock, or where the file system has none.
bool FolderLock::wait(int operation) {
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  while (::flock(descriptor_, operation | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

bool FolderLock::is_still(const fs::path& folder) const {
  struct stat held {
  }, there{};
  return ::fstat(descriptor_, &held) == 0 && ::stat(folder.c_str(), &there) == 0 && held.st_ino == there.st_ino &&
         held.st_dev == there.st_dev;
}

}  // namespace finemote::gen
