#include "generated/compiler.hpp"

#include <chrono>
#include <cstdio>

#include "cli/program.hpp"

namespace finemote::test {
namespace {

constexpr std::chrono::seconds kLimit(600);

Compiler with_common_flags(std::string name, std::vector<std::string> command) {
  for (const char* flag : {"-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off"})
    command.emplace_back(flag);
  command.insert(command.end(), {"-I", source_path("runtime/include")});
  return {std::move(name), std::move(command)};
}

}  // namespace

std::vector<Compiler> compilers() {
  std::vector<Compiler> found{with_common_flags("host", {FINEMOTE_CXX, "-O0"})};
  if (!gen::run_process({"arm-none-eabi-g++", "--version"}, kLimit).started) {
    std::fputs("arm-none-eabi-g++ is missing: nothing is compiled for the board\n", stderr);
    return found;
  }
  found.push_back(with_common_flags(
      "board", {"arm-none-eabi-g++", "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard",
                "-fno-builtin", "--specs=nano.specs", "-Os", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
                "-fno-use-cxa-atexit", "-ffunction-sections", "-fdata-sections"}));
  return found;
}

std::string complaint(const Compiler& compiler, const std::string& source, const std::vector<std::string>& includes) {
  std::vector<std::string> command = compiler.command;
  for (const std::string& folder : includes) command.insert(command.end(), {"-I", folder});
  command.insert(command.end(), {"-S", "-o", "/dev/null", source});
  const gen::ProcessResult result = gen::run_process(command, kLimit);
  if (result.started && result.exit_status == 0) return {};
  return compiler.name + ": " + source + "\n" + result.output;
}

std::string complaint_about(const Compiler& compiler, const std::string& generated,
                            const std::vector<std::string>& includes) {
  std::vector<std::string> folders = includes;
  folders.insert(folders.begin(), generated);
  for (const auto& [name, text] : files_below(generated)) {
    if (name.size() < 4 || name.substr(name.size() - 4) != ".cpp") continue;
    std::string said = complaint(compiler, generated + "/" + name, folders);
    if (!said.empty()) return said;
  }
  return {};
}

}  // namespace finemote::test
