#include "generator/image/debug_file.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace finemote::gen {

DebugFile::DebugFile(const std::string& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ >= 0) dwarf_ = dwarf_begin(descriptor_, DWARF_C_READ);
}

DebugFile::~DebugFile() {
  if (dwarf_ != nullptr) dwarf_end(dwarf_);
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace finemote::gen
