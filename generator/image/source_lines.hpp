// Addresses of an image to the lines of sources they were compiled from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace finemote::gen {

struct SourceLine {
  std::string file;  ///< as the compiler was told
  int line = 0;
};

/// By the debug information of an image; without any, no address has a line.
class SourceLines {
 public:
  explicit SourceLines(const std::string& path);
  ~SourceLines();
  SourceLines(const SourceLines&) = delete;
  SourceLines& operator=(const SourceLines&) = delete;

  [[nodiscard]] std::optional<SourceLine> at(std::uint32_t address) const;

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace finemote::gen
