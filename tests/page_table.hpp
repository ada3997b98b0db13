// Tables of documentation pages that tests write.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/rewrites.hpp"

namespace finemote::test {

/// A row of a table in Markdown.
inline std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// A page whose tables stand between comments that name them. It is written where rewrites().
class PageTables {
 public:
  /// @param page  below the project's folder
  explicit PageTables(const std::string& page) : path_(source_dir() + "/" + page), text_(read(path_)) {}

  void put(const std::string& name, const std::string& table) {
    const std::string begin = "<!-- table: " + name + " -->\n";
    const std::size_t at = text_.find(begin), end = text_.find("<!-- end of table -->", at);
    INFO(name);
    REQUIRE(at != std::string::npos);
    REQUIRE(end != std::string::npos);
    text_.replace(at + begin.size(), end - at - begin.size(), "\n" + table + "\n");
  }

  /// That the page has these tables.
  void hold() const {
    if (rewrites()) std::ofstream(path_, std::ios::binary) << text_;
    CHECK(read(path_) == text_);
  }

 private:
  std::string path_, text_;
};

}  // namespace finemote::test
