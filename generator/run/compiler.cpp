#include "generator/run/compiler.hpp"

#include "generator/run/process.hpp"

namespace finemote::gen {

std::string compiler_for_board() {
  const ProcessResult result = run_process({"arm-none-eabi-g++", "--version"}, std::chrono::seconds(10));
  return result.started ? result.output.substr(0, result.output.find('\n')) : std::string();
}

}  // namespace finemote::gen
