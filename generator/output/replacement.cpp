#include "generator/output/replacement.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <set>
#include <utility>

#include "generator/file/replace_file.hpp"
#include "generator/output/folder.hpp"
#include "generator/output/lock.hpp"

namespace finemote::gen {

namespace fs = std::filesystem;

namespace {

/// Renames, or throws with the name a user knows.
void move(const fs::path& from, const fs::path& to, const fs::path& known) {
  std::error_code failed;
  fs::rename(from, to, failed);
  if (failed) throw fs::filesystem_error("", known, failed);
}

}  // namespace

Replacement::Replacement(fs::path root) : root_(std::move(root)) {}

Replacement::~Replacement() {
  std::error_code ignored;
  for (auto step = done_.rbegin(); step != done_.rend(); ++step) {
    if (step->before.empty()) {
      fs::remove(step->at, ignored);
    } else {
      fs::rename(step->before, step->at, ignored);
    }
  }
  for (const fs::path& path : staged_) fs::remove(path, ignored);
  for (const fs::path& path : backups_) fs::remove(path, ignored);
  remove_folders(created_);
}

fs::path Replacement::temporary(const std::string& name) const {
  return root_ / fmt::format("{}{}-{}", name, kTemporaryMark, ::getpid());
}

fs::path Replacement::backup(const std::string& name) const {
  return root_ / fmt::format("{}{}-{}-old", name, kTemporaryMark, ::getpid());
}

void Replacement::clean_up(const std::vector<std::string>& names) {
  std::set<std::string> known(names.begin(), names.end());
  std::set<fs::path> folders;
  for (const std::string& name : names) folders.insert((root_ / name).parent_path());
  for (const fs::path& folder : folders) {
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().lexically_relative(root_).generic_string();
      const auto mark = name.find(kTemporaryMark);
      const bool is_left_over = mark != std::string::npos && known.count(name.substr(0, mark)) > 0;
      if (is_left_over && entry->is_regular_file(ignored)) fs::remove(entry->path(), ignored);
    }
  }
}

void Replacement::stage(const std::string& name, const std::string& text) {
  for (fs::path& path : create_folders((root_ / name).parent_path())) created_.push_back(std::move(path));
  const int error = create_file(temporary(name), text);
  if (error != 0) throw fs::filesystem_error("", root_ / name, std::error_code(error, std::generic_category()));
  staged_.push_back(temporary(name));
}

void Replacement::put(const std::string& name) {
  const fs::path path = root_ / name;
  std::error_code ignored, failed;
  const bool is_there = fs::exists(fs::symlink_status(path, ignored));
  if (is_there) {
    // Where a file system has no second names, a failure in the middle of the renames cannot be undone.
    fs::create_hard_link(path, backup(name), failed);
    if (!failed) backups_.push_back(backup(name));
  }
  move(temporary(name), path, path);
  if (!is_there) done_.push_back({path, {}});
  if (is_there && !failed) done_.push_back({path, backup(name)});
}

void Replacement::take_away(const std::string& name) {
  move(root_ / name, backup(name), root_ / name);
  backups_.push_back(backup(name));
  done_.push_back({root_ / name, backup(name)});
}

void Replacement::set_aside(const std::string& name, const std::string& to) {
  move(root_ / name, root_ / to, root_ / name);
  done_.push_back({root_ / name, root_ / to});
}

void Replacement::keep() {
  done_.clear();
  staged_.clear();
  created_.clear();
}

}  // namespace finemote::gen
