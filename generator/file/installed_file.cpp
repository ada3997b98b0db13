#include "generator/file/installed_file.hpp"

#include <fstream>
#include <sstream>

namespace finemote::gen {

std::string read_installed(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text) throw DamagedInstallation(path);
  return text.str();
}

}  // namespace finemote::gen
