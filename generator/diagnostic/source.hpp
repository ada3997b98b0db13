// Input texts and places in them: what every element, attribute and message of the tool points at.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include "generator/file/access.hpp"

namespace finemote::gen {

/// One input text, kept for excerpts in messages.
struct SourceFile {
  std::string name;  ///< as shown in messages and written to outputs: relative, with '/' separators
  std::string path;  ///< as opened; empty for standard input
  std::string text;

  /// The line with 1-based number `line`, without its line break; empty when out of range.
  [[nodiscard]] std::string_view line(std::uint32_t line) const;
  /// Where a program that reads messages finds it, from the working folder on; the name of what comes with FineMote.
  [[nodiscard]] std::string place() const;
};

struct Expansion;

/// A place in an input. Columns count bytes from 1; 0 means unknown. A default position points nowhere.
struct Position {
  const SourceFile* file = nullptr;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  const Expansion* via = nullptr;  ///< innermost macro call or include the text came through; null at top level

  friend bool operator==(const Position&, const Position&) = default;
};

/// One step of the way from the text a user wrote to an expanded element.
struct Expansion {
  enum class Kind { macro, include };
  Kind kind = Kind::macro;
  std::string name;  ///< macro name or included file
  Position at;       ///< the macro call or the include tag; at.via is the next step outwards
};

/// Owns all texts and expansion steps of one run, so that positions stay small and valid, and knows which files may
/// become such texts. Move-only: positions point into it.
class Sources {
 public:
  Sources() = default;
  explicit Sources(files::Access access) : access_(std::move(access)) {}
  Sources(const Sources&) = delete;
  Sources& operator=(const Sources&) = delete;
  Sources(Sources&&) = default;
  Sources& operator=(Sources&&) = default;

  const SourceFile* add(SourceFile file) { return &files_.emplace_back(std::move(file)); }
  const Expansion* add(Expansion step) { return &steps_.emplace_back(std::move(step)); }
  [[nodiscard]] const std::deque<SourceFile>& files() const { return files_; }
  [[nodiscard]] const files::Access& access() const { return access_; }

 private:
  std::deque<SourceFile> files_;
  std::deque<Expansion> steps_;
  files::Access access_;
};

/// True when `a` stands before `b` in reading order: files in order of first use, then line, then column.
/// Positions reached through an expansion sort by its outermost step, where the user reads.
bool before(const Position& a, const Position& b);

}  // namespace finemote::gen
