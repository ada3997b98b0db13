#include "generator/run/program_folder.hpp"

#include <system_error>

namespace finemote::gen {

std::filesystem::path program_folder() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

}  // namespace finemote::gen
