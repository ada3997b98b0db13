#include "generator/cli/sandbox.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string_view>

#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/file/inside.hpp"
#include "generator/input/input.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMemory = rlim_t{2} << 30;  // bytes of address space, a stack of 512 MiB for xacro included
constexpr rlim_t kSeconds = 60;              // of processor time

/// The folder a command takes from one of its operands: of a file, of standard input, or a generated one itself.
fs::path folder_of(const std::string& input) {
  std::error_code ignored;
  if (input == "-") return fs::current_path(ignored);
  if (fs::is_directory(input, ignored)) return input;
  const fs::path parent = fs::path(input).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

/// What the user names by its place below the working directory has to be there: a branch may hold links.
void check_folder(const fs::path& folder, Diagnostics& diagnostics) {
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  const fs::path named = fs::absolute(folder, failed).lexically_normal();
  const fs::path real = fs::weakly_canonical(folder, failed);
  if (failed) return;
  if (real == real.root_path()) {
    diagnostics.error(code::outside_sandbox, {}, "the sandbox cannot hold the whole file system")
        .hint("put the input into a folder of its own");
  } else if (inside(named, here) && !inside(real, fs::weakly_canonical(here, failed))) {
    diagnostics
        .error(code::outside_sandbox, {},
               fmt::format("folder '{}' is a symbolic link out of the working directory", folder.generic_string()))
        .hint("give the folder itself");
  }
}

std::vector<std::string> named_folders(const Options& options) {
  std::vector<std::string> folders;
  for (const std::string& input : {options.input, options.other}) {
    if (!input.empty()) folders.push_back(folder_of(input).string());
  }
  for (const std::string& word : options.packages) {
    const auto package = package_of(word);
    if (package && !package->second.empty()) folders.push_back(package->second);
  }
  folders.insert(folders.end(), options.device_paths.begin(), options.device_paths.end());
  return folders;
}

static_assert(kSeconds == 60 && code::sandbox_limit == Code{9}, "the words below say so");

/// Runs in a signal: calls nothing but the system.
void end_at_time_limit(int /*signal*/) {
  constexpr std::string_view words =
      "finemote: error[FM0009]: the input needs more than the 60 s of processor time that the sandbox allows\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words.data(), words.size());
  ::_exit(kExitInvalid);
}

void lower_limit(__rlimit_resource resource, rlim_t wanted, rlim_t slack) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0) return;
  limit.rlim_max = std::min(limit.rlim_max, wanted + slack);
  limit.rlim_cur = std::min(limit.rlim_cur, std::min(wanted, limit.rlim_max));
  ::setrlimit(resource, &limit);
}

}  // namespace

files::Access read_access(const Options& options, Diagnostics& diagnostics) {
  if (!options.sandbox) return {};
  std::vector<std::string> folders = named_folders(options);
  for (const std::string& folder : folders) check_folder(folder, diagnostics);
  Diagnostics reported_later;
  const fs::path data = find_data_dir(options.data_dir, reported_later);
  if (!data.empty()) folders.push_back((data / "schemas").string());
  return files::Access::sandbox(folders);
}

void bound_resources() {
  std::signal(SIGXCPU, end_at_time_limit);
  lower_limit(RLIMIT_CPU, kSeconds, 5);
#ifndef __SANITIZE_ADDRESS__  // its shadow takes terabytes of address space
  lower_limit(RLIMIT_AS, kMemory, 0);
#endif
}

void report_memory_limit(Diagnostics& diagnostics) {
  diagnostics.error(
      code::sandbox_limit, {},
      fmt::format("the input needs more than the {} GiB of memory that the sandbox allows", kMemory >> 30));
}

}  // namespace finemote::gen
