#include "generator/run/build_firmware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "generator/file/replace_file.hpp"
#include "generator/output/folder.hpp"
#include "generator/run/process.hpp"
#include "generator/timing_file/inputs_hash.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
constexpr std::chrono::seconds kLongestBuild{600};

std::string cmake_list(const char* keyword, const std::vector<std::string>& paths) {
  return paths.empty() ? std::string() : fmt::format(" {} {}", keyword, cmake_words(paths));
}

/// What a build said without its progress and its commands: what is left are the compiler's messages.
std::string messages_of(const std::string& output) {
  std::istringstream lines(output);
  std::string messages;
  for (std::string line; std::getline(lines, line);) {
    const bool is_progress = line.rfind("[", 0) == 0 || line.rfind("FAILED: ", 0) == 0 || line.rfind("ninja: ", 0) == 0;
    const bool is_command = line.find(" -o CMakeFiles/") != std::string::npos || line.rfind(": && ", 0) == 0;
    if (!is_progress && !is_command) messages += line + "\n";
  }
  return messages;
}

/// FM0006, once, for the first of the programs that cannot be started.
bool are_there(const std::vector<std::pair<std::string, std::string>>& programs, Diagnostics& diagnostics) {
  for (const auto& [program, packages] : programs) {
    if (run_process({program, "--version"}, std::chrono::seconds(10)).started) continue;
    report_not_started(program, "install it, for example: apt-get install " + packages, diagnostics);
    return false;
  }
  return true;
}

constexpr const char* kArmPackages = "gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib";

/// What a build for the board needs, with the packages of Debian it comes in. On the host CMake finds a compiler under
/// many names.
std::vector<std::pair<std::string, std::string>> tools_for(bool for_host) {
  std::vector<std::pair<std::string, std::string>> tools{{"cmake", "cmake"}, {"ninja", "ninja-build"}};
  if (for_host) {
    if (std::getenv("CXX") == nullptr) tools.emplace_back("c++", "g++");
  } else {
    tools.emplace_back("arm-none-eabi-g++", kArmPackages);
  }
  return tools;
}

/// What the linker says of the regions that code in SRAM leaves for code and for variables: sections_sram.ld.
bool is_too_large_for_sram(const std::string& output) {
  const auto says = [&](const char* words) { return output.find(words) != std::string::npos; };
  return says("board_sram.ld") && (says("region `CODE' overflowed") || says("region `CORE_RAM' overflowed"));
}

/// What newlib asks for where the code allocates: firmware has no heap, so it is not there.
bool wants_heap(const std::string& output) {
  return output.find("undefined reference to `_sbrk'") != std::string::npos;
}

/// The first whole lines, and how many were left out.
std::string shortened(const std::string& output) {
  constexpr std::size_t kMostShown = 4000;
  if (output.size() <= kMostShown) return output;
  const std::size_t last = output.rfind('\n', kMostShown);
  const std::size_t end = last == std::string::npos ? kMostShown : last + 1;
  const auto left = std::count(output.begin() + static_cast<std::ptrdiff_t>(end), output.end(), '\n');
  return output.substr(0, end) +
         fmt::format("... and {} more line{}\n", std::max<std::ptrdiff_t>(left, 1), left > 1 ? "s" : "");
}

/// What a shell has set for other programs is none of the firmware's options.
std::vector<std::string> build_environment() {
  return {"CCACHE_NOHASHDIR=1", "CXXFLAGS",     "CFLAGS",        "CPPFLAGS",
          "ASMFLAGS",           "LDFLAGS",      "CPATH",         "C_INCLUDE_PATH",
          "CPLUS_INCLUDE_PATH", "LIBRARY_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX",
          "CMAKE_BUILD_TYPE"};
}

/// Runs one step; false and a diagnostic when it fails.
bool step(const std::vector<std::string>& command, const char* what, Diagnostics& diagnostics) {
  const ProcessResult result = run_process(command, kLongestBuild, build_environment());
  if (result.started && !result.timed_out && result.exit_status == 0) return true;
  if (!result.started) {
    report_not_started(command.front(),
                       fmt::format("install it, for example: apt-get install cmake ninja-build {}", kArmPackages),
                       diagnostics);
    return false;
  }
  auto& finding =
      diagnostics.error(code::firmware_build_failed, {},
                        result.timed_out ? fmt::format("{} took longer than {} s", what, kLongestBuild.count())
                                         : fmt::format("{} failed", what));
  finding.note("\n" + shortened(messages_of(result.output)));
  if (wants_heap(result.output))
    finding.hint("there is no heap: keep what std::vector, std::string or new would allocate in members of fixed size");
  if (messages_of(result.output).find("[-Werror=date-time]") != std::string::npos)
    finding.hint("__DATE__ and __TIME__ change the image on every build, so no bound would apply to it: remove them");
  if (is_too_large_for_sram(result.output))
    finding.hint("with its code in flash, where it has more room: <param name=\"code\">flash</param> in <board>");
  return false;
}

/// Names of all sources below a folder, in order.
std::set<std::string> sources_below(const fs::path& folder) {
  std::set<std::string> sources;
  std::error_code failed;
  for (fs::recursive_directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    if (it->path().extension() == ".cpp") sources.insert(it->path().generic_string());
  }
  return sources;
}

/// What the configuration of a work folder follows from: the runtime, its project, and the names of the sources, which
/// CMake looks for.
std::string configuration_of(const FirmwareRequest& request) {
  std::string text = shipped_digest(request.data_dir, request.board) + "\n";
  text += fs::absolute(request.folder).generic_string() + "\n" + project_text(request);
  for (const fs::path& folder : {fs::path(request.folder) / "generated", fs::path(request.data_dir) / "runtime"}) {
    for (const std::string& source : sources_below(folder)) text += source + "\n";
  }
  return text;
}

/// Left in the build folder by a configuration that succeeded.
fs::path configuration_file(const fs::path& build) { return build / "finemote.configuration"; }

/// Whether CMake has nothing to do that the build would not ask it for.
bool is_configured(const fs::path& build, const std::string& configuration) {
  return fs::exists(build / "build.ninja") && read_bytes(configuration_file(build).string()) == configuration;
}

/// Whether what was compiled in the folder may be of another runtime. Ninja does not see it: the dates of a package are
/// its commit's, before those of what was compiled since.
bool is_of_other_runtime(const fs::path& build, const std::string& configuration) {
  if (!fs::exists(build / "build.ninja")) return false;
  const auto before = read_bytes(configuration_file(build).string());
  const std::string digest = configuration.substr(0, configuration.find('\n') + 1);
  return !before || !before->starts_with(digest);
}

bool configure(const FirmwareRequest& request, const fs::path& build, const std::string& configuration,
               Diagnostics& diagnostics) {
  const bool is_stale = is_of_other_runtime(build, configuration);
  std::error_code ignored;
  fs::remove(configuration_file(build), ignored);
  // Where it was configured before, the programs were there.
  if (!fs::exists(build / "build.ninja") && !are_there(tools_for(request.for_host), diagnostics)) return false;
  std::vector<std::string> command{"cmake", "-S", request.folder, "-B", build.string(), "-G", "Ninja"};
  if (!fs::exists(build / "CMakeCache.txt") && run_process({"ccache", "--version"}, std::chrono::seconds(10)).started) {
    command.emplace_back("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache");
  }
  if (!request.for_host) {
    command.push_back("-DCMAKE_TOOLCHAIN_FILE=" +
                      fs::absolute(request.data_dir + "/cmake/toolchain-arm-none-eabi.cmake").string());
  }
  if (!step(command, "configuring the firmware", diagnostics)) return false;
  if (is_stale && !step({"ninja", "-C", build.string(), "-t", "clean"}, "cleaning the folder", diagnostics))
    return false;
  static_cast<void>(replace_file(configuration_file(build).string(), configuration));
  return true;
}

}  // namespace

std::string cmake_words(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths)
    text += fmt::format("{}[==[{}]==]", text.empty() ? "" : " ", fs::absolute(path).generic_string());
  return text;
}

std::string project_text(const FirmwareRequest& request) {
  std::ostringstream project;
  project << "cmake_minimum_required(VERSION 3.25)\n"
          << "project(firmware LANGUAGES CXX" << (request.for_host ? "" : " ASM") << ")\n"
          << fmt::format("file(WRITE ${{CMAKE_BINARY_DIR}}/{} \"${{CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}}\")\n",
                         kCompilerFolders)
          << (request.is_reproducible ? "add_compile_options(-Werror=date-time)\n" : "")
          << fmt::format("include([==[{}/cmake/FinemoteFirmware.cmake]==])\n",
                         fs::absolute(request.data_dir).generic_string())
          << "finemote_add_firmware(" << request.name << " GENERATED ${CMAKE_CURRENT_SOURCE_DIR}/generated BOARD "
          << request.board << (request.trace ? " TRACE" : "") << (request.monitor ? " WATCH_BOUNDS" : "")
          << (request.duration > Duration::zero() ? fmt::format(" DURATION {}ns", request.duration.ns()) : "")
          << " CODE " << (request.code_in_sram ? "sram" : "flash")
          << (request.stack > 0 ? fmt::format(" STACK {}", request.stack) : "")
          << cmake_list("INCLUDES", request.include_dirs) << cmake_list("SOURCES", request.sources) << ")\n";
  return project.str();
}

std::string image_path(const FirmwareRequest& request) {
  return (fs::path(request.folder) / "build" / (request.name + (request.for_host ? "" : ".elf"))).string();
}

bool can_build(const FirmwareRequest& request) {
  Diagnostics ignored;
  return are_there(tools_for(request.for_host), ignored);
}

std::optional<std::string> build_firmware(const FirmwareRequest& request, Diagnostics& diagnostics) {
  const fs::path build = fs::path(request.folder) / "build";
  const std::string configuration = configuration_of(request);
  if (!is_configured(build, configuration) && !configure(request, build, configuration, diagnostics))
    return std::nullopt;
  if (!step({"ninja", "-C", build.string()}, "compiling the firmware", diagnostics)) return std::nullopt;
  return image_path(request);
}

}  // namespace finemote::gen
