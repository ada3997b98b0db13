// The files and macros an expansion stands in, and how deep and how often it may enter them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/xacro/macro.hpp"

namespace finemote::gen::xacro {

class Trail {
 public:
  explicit Trail(std::string entry) : files_{std::move(entry)} {}

  /// The file being processed, by the path it was opened with.
  [[nodiscard]] const std::string& file() const { return files_.back(); }
  /// A path relative to the file being processed; absolute paths unchanged.
  [[nodiscard]] std::string absolute(const std::string& path) const;
  /// Where the expansion stands, as ROS xacro tells it: innermost first, one line each.
  [[nodiscard]] std::vector<std::string> lines() const;

  /// Counts an expansion of something that is written once; fails with FM1011 at `at` when there are too many.
  void count(const char* too_many, const Position& at);
  /// Fails when a file may not be included any more.
  void check_include(const std::string& file, const Position& at);

  /// A file or macro that is left at the end of a block.
  template <typename Entry>
  class [[nodiscard]] Inside {
   public:
    Inside(std::vector<Entry>& open, Entry entry) : open_(open) { open_.push_back(std::move(entry)); }
    ~Inside() { open_.pop_back(); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

   private:
    std::vector<Entry>& open_;
  };
  Inside<std::string> enter_file(const std::string& file) { return {files_, file}; }
  /// Fails when calls are nested too deeply, or there are too many.
  Inside<const Macro*> enter_macro(const Macro& macro, const Position& at);
  /// Fails with `too_deep` when blocks are nested too deeply.
  [[nodiscard]] Level enter_block(const char* too_deep, const Position& at);

 private:
  std::vector<std::string> files_;    // the file being processed, last
  std::vector<const Macro*> macros_;  // the macro being expanded, last
  std::size_t blocks_ = 0;            // open
  std::size_t expansions_ = 0;        // of macros, files and blocks
};

}  // namespace finemote::gen::xacro
