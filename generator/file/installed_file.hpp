// Files that come with finemote: templates, tables, pages.
#pragma once

#include <stdexcept>
#include <string>

namespace finemote::gen {

/// What helps against every damage of the installation.
inline constexpr const char* kInstallAgain = "install finemote again, or give another folder with --data-dir";

/// A file of the installation is missing or unusable; `what()` names it. The command line reports it as such.
class DamagedInstallation : public std::runtime_error {
 public:
  explicit DamagedInstallation(const std::string& path)
      : std::runtime_error("cannot read '" + path + "', which belongs to finemote") {}
};

/// All bytes of a file of the installation. Throws DamagedInstallation.
std::string read_installed(const std::string& path);

}  // namespace finemote::gen
