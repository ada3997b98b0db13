// The debug information of an image, opened.
#pragma once

#include <elfutils/libdw.h>

#include <string>

namespace finemote::gen {

class DebugFile {
 public:
  explicit DebugFile(const std::string& path);
  ~DebugFile();
  DebugFile(const DebugFile&) = delete;
  DebugFile& operator=(const DebugFile&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  /// Null: the file has none.
  [[nodiscard]] Dwarf* dwarf() const { return dwarf_; }

 private:
  int descriptor_;
  Dwarf* dwarf_ = nullptr;
};

}  // namespace finemote::gen
