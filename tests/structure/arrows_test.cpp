// Which folder of the generator may use which: what generator/README.md lists, and nothing against its order.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using finemote::test::read;

namespace {

/// One row of the list: `| `folder` | what it does | the folders it uses |`.
struct Row {
  std::string folder;
  std::set<std::string> uses;
};

const fs::path kGenerator = fs::path(finemote::test::source_dir()) / "generator";

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) cells.push_back(cell);
  return cells;
}

std::set<std::string> words_of(const std::string& text) {
  std::istringstream rest(text);
  std::set<std::string> words;
  for (std::string word; rest >> word;) words.insert(word);
  return words;
}

/// The rows of the table under `## Folders`, in order.
std::vector<Row> listed_rows() {
  std::istringstream page(read(kGenerator / "README.md"));
  std::vector<Row> rows;
  bool is_inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) is_inside = line == "## Folders";
    if (!is_inside || line.rfind("| `", 0) != 0) continue;
    const std::vector<std::string> cells = cells_of(line);
    REQUIRE(cells.size() == 3);
    rows.push_back({line.substr(3, line.find('`', 3) - 3), words_of(cells[2])});
  }
  return rows;
}

/// The folder of a path below `generator/`; files beside the folders are the pipeline.
std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? "pipeline" : path.substr(0, slash);
}

/// Folders that each folder includes, with one file that does.
std::map<std::string, std::map<std::string, std::string>> included_folders() {
  const std::string begin = "#include \"generator/";
  std::map<std::string, std::map<std::string, std::string>> arrows;
  for (const auto& entry : fs::recursive_directory_iterator(kGenerator)) {
    const fs::path extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    const std::string file = entry.path().lexically_relative(kGenerator).generic_string();
    auto& used = arrows[folder_of(file)];
    std::istringstream text(read(entry.path()));
    for (std::string line; std::getline(text, line);) {
      if (line.rfind(begin, 0) != 0 || line.find("version.hpp") != std::string::npos) continue;
      const std::string other = folder_of(line.substr(begin.size()));
      if (other != folder_of(file)) used.emplace(other, file);
    }
  }
  return arrows;
}

}  // namespace

TEST_CASE("a folder of the generator includes only those that generator/README.md allows it") {
  const std::vector<Row> rows = listed_rows();
  REQUIRE_FALSE(rows.empty());
  for (const auto& [folder, arrows] : included_folders()) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&, name = folder](const Row& r) { return r.folder == name; });
    if (row == rows.end()) {
      FAIL_CHECK("generator/" << folder << " is not in the list of generator/README.md");
      continue;
    }
    for (const auto& [used, file] : arrows) {
      if (!row->uses.contains(used))
        FAIL_CHECK("generator/" << file << " includes '" << used << "', which is not listed");
    }
    for (const std::string& used : row->uses) {
      if (!arrows.contains(used)) FAIL_CHECK("'" << folder << "' does not use '" << used << "': take it from the list");
    }
  }
}

TEST_CASE("arrows point up the page: a folder uses only folders listed before it") {
  std::set<std::string> before;
  for (const Row& row : listed_rows()) {
    for (const std::string& used : row.uses) {
      if (!before.contains(used))
        FAIL_CHECK("'" << row.folder << "' uses '" << used << "', which is not listed before it");
    }
    before.insert(row.folder);
  }
}

namespace {

/// Whether a file below `folder` includes something of `other`.
void check_apart(const std::string& folder, const std::vector<std::string>& others) {
  const fs::path top = fs::path(finemote::test::source_dir()) / folder;
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(top)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    ++files;
    const std::string text = read(entry.path());
    for (const std::string& other : others) {
      if (text.find("#include \"" + other) != std::string::npos)
        FAIL_CHECK(entry.path().filename().generic_string() << " includes '" << other << "'");
    }
  }
  CHECK(files > 10);
}

}  // namespace

TEST_CASE("what bounds execution times and what emulates them share nothing") {
  check_apart("generator/wcet", {"emulator/"});
  check_apart("generator/image", {"emulator/"});
  check_apart("emulator", {"generator/wcet", "generator/image"});
}
