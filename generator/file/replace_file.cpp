#include "generator/file/replace_file.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "generator/file/system_reason.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

mode_t mode_for(const fs::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

bool is_special(const fs::path& path) {
  const std::string text = path.string();
  for (const char* stream : {"/dev/stdin", "/dev/stdout", "/dev/stderr"}) {
    if (text == stream) return true;
  }
  if (text.starts_with("/dev/fd/") || text.starts_with("/proc/")) return true;
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;  // what the system follows as well
  std::error_code failed;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, failed); ++i) {
    const fs::path target = fs::read_symlink(path, failed);
    if (failed) break;
    path = path.parent_path() / target;  // an absolute target replaces what is before it
  }
  return path;
}

ReplacedFile::ReplacedFile(const std::string& path) : stream_(&buffer_) {
  if (is_special(path)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor_ < 0) error_ = errno;
  } else {
    open_beside(behind_links(path));
  }
  buffer_.attach(descriptor_);
}

void ReplacedFile::open_beside(const fs::path& target) {
  target_ = target;
  std::string pattern = target.string() + ".finemote-tmp-XXXXXX";
  descriptor_ = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    error_ = errno;
    return;
  }
  temporary_ = pattern;
  if (::fchmod(descriptor_, mode_for(target)) != 0) error_ = errno;
}

ReplacedFile::~ReplacedFile() {
  close_descriptor();
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

int ReplacedFile::close_descriptor() {
  if (descriptor_ < 0) return 0;
  const int status = ::close(descriptor_);
  descriptor_ = -1;
  return status == 0 ? 0 : errno;
}

std::optional<std::string> ReplacedFile::commit() {
  if (error_ == 0) {
    stream_.flush();
    error_ = buffer_.error();
    if (const int closing = close_descriptor(); error_ == 0) error_ = closing;
  }
  if (error_ == 0 && !temporary_.empty()) {
    if (::rename(temporary_.c_str(), target_.c_str()) == 0) {
      temporary_.clear();
    } else {
      error_ = errno;
    }
  }
  if (error_ == 0) return std::nullopt;
  return system_reason(error_);
}

std::optional<std::string> replace_file(const std::string& path, std::string_view text) {
  ReplacedFile file(path);
  file.stream() << text;
  return file.commit();
}

std::optional<std::string> why_not_replaced(const std::string& path) {
  const bool is_direct = is_special(path);
  if (is_direct && fs::is_directory(path)) return system_reason(EISDIR);
  const fs::path folder = behind_links(path).parent_path();
  const fs::path written = is_direct ? fs::path(path) : folder.empty() ? fs::path(".") : folder / "";
  const int needed = is_direct ? W_OK : W_OK | X_OK;
  if (::faccessat(AT_FDCWD, written.c_str(), needed, AT_EACCESS) == 0) return std::nullopt;
  return system_reason(errno);
}

int create_file(const fs::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  DescriptorBuffer buffer(descriptor);
  std::ostream stream(&buffer);
  stream << text << std::flush;
  const int closed = ::close(descriptor) == 0 ? 0 : errno;
  const int error = buffer.error() != 0 ? buffer.error() : closed;
  if (error != 0) ::unlink(path.c_str());
  return error;
}

}  // namespace finemote::gen
