#include "generator/cli/watch.hpp"

#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "generator/cli/settings.hpp"
#include "generator/input/input.hpp"
#include "generator/timing_file/timing_file.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

constexpr auto kPause = std::chrono::milliseconds(100);

}  // namespace

std::vector<std::string> watched_paths(const Options& options, const Sources& sources) {
  const std::string folder = input_folder(options.input);
  std::vector<std::string> paths{options.input, folder + "/" + kSettingsName, folder + "/devices"};
  if (const std::string times = timing_file_path(options.input); !times.empty()) paths.push_back(times);
  paths.insert(paths.end(), options.device_paths.begin(), options.device_paths.end());
  if (options.command == "check" && !options.out.empty()) paths.push_back(options.out);  // others write it
  for (const SourceFile& file : sources.files()) {
    if (!file.path.empty()) paths.push_back(file.path);
  }
  return paths;
}

Watched::Watched(std::vector<std::string> paths) : paths_(std::move(paths)), marks_(look()) {}

void Watched::wait() const {
  Marks last = look();
  for (bool is_changed = last != marks_; true; is_changed = true) {
    while (!is_changed) {
      std::this_thread::sleep_for(kPause);
      last = look();
      is_changed = last != marks_;
    }
    std::this_thread::sleep_for(kPause);  // an editor may not be done
    const Marks now = look();
    if (now == last) return;
    last = now;
  }
}

Watched::Marks Watched::look() const {
  Marks marks;
  const auto add = [&](const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return;
    constexpr std::uint64_t second = 1'000'000'000;
    marks[path] = {
        static_cast<std::uint64_t>(status.st_size),
        static_cast<std::uint64_t>(status.st_mtim.tv_sec) * second + static_cast<std::uint64_t>(status.st_mtim.tv_nsec),
        status.st_ino};
  };
  for (const std::string& path : paths_) {
    add(path);
    std::error_code error;
    for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
      add(entry->path().string());
  }
  return marks;
}

}  // namespace finemote::gen
