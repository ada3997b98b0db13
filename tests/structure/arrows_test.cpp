// Which folder of the generator may use which, and what it and the emulator use of each other: what generator/README.md
// and emulator/README.md list, and nothing against their order.
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

const fs::path kSources = finemote::test::source_dir();
const fs::path kGenerator = kSources / "generator";
const std::string kEmulator = "emulator";  ///< the folder beside the generator, in the list of what its folders use

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

/// Folders of what is included, with one file that does.
using Included = std::map<std::string, std::string>;

bool is_source(const fs::path& file) { return file.extension() == ".cpp" || file.extension() == ".hpp"; }

/// The folder of the generator that a line of a file includes, or the emulator; empty: neither.
std::string included_folder(const std::string& line) {
  const std::string begin = "#include \"generator/";
  if (line.rfind("#include \"" + kEmulator + "/", 0) == 0) return kEmulator;
  if (line.rfind(begin, 0) != 0 || line.find("version.hpp") != std::string::npos) return "";
  return folder_of(line.substr(begin.size()));
}

/// Adds what a file includes of folders other than its own.
void note_included(const fs::path& file, const std::string& own, Included& used) {
  std::istringstream text(read(file));
  for (std::string line; std::getline(text, line);) {
    const std::string folder = included_folder(line);
    if (!folder.empty() && folder != own) used.emplace(folder, file.lexically_relative(kSources).generic_string());
  }
}

/// Of each folder of the generator.
std::map<std::string, Included> included_by_folders() {
  std::map<std::string, Included> arrows;
  for (const auto& entry : fs::recursive_directory_iterator(kGenerator)) {
    if (!is_source(entry.path())) continue;
    const std::string folder = folder_of(entry.path().lexically_relative(kGenerator).generic_string());
    note_included(entry.path(), folder, arrows[folder]);
  }
  return arrows;
}

/// Folders of the generator that the emulator includes.
Included included_by_emulator() {
  Included used;
  for (const auto& entry : fs::recursive_directory_iterator(kSources / kEmulator)) {
    if (is_source(entry.path())) note_included(entry.path(), kEmulator, used);
  }
  return used;
}

/// Folders of the generator that the emulator may use: the words in backquotes of one line of its page.
std::set<std::string> listed_for_emulator() {
  std::istringstream page(read(kSources / kEmulator / "README.md"));
  std::set<std::string> folders;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("From the generator it takes ", 0) != 0) continue;
    std::istringstream rest(line);
    for (std::string text, folder; std::getline(rest, text, '`') && std::getline(rest, folder, '`');)
      folders.insert(folder);
  }
  return folders;
}

}  // namespace

TEST_CASE("a folder of the generator includes only those that generator/README.md allows it") {
  const std::vector<Row> rows = listed_rows();
  REQUIRE_FALSE(rows.empty());
  for (const auto& [folder, arrows] : included_by_folders()) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&, name = folder](const Row& r) { return r.folder == name; });
    if (row == rows.end()) {
      FAIL_CHECK("generator/" << folder << " is not in the list of generator/README.md");
      continue;
    }
    for (const auto& [used, file] : arrows) {
      if (!row->uses.contains(used)) FAIL_CHECK(file << " includes '" << used << "', which is not listed");
    }
    for (const std::string& used : row->uses) {
      if (!arrows.contains(used)) FAIL_CHECK("'" << folder << "' does not use '" << used << "': take it from the list");
    }
  }
}

TEST_CASE("the reading orders of generator/README.md name headers that are there") {
  std::istringstream page(read(kGenerator / "README.md"));
  fs::path folder;
  std::size_t names = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) folder.clear();
    if (line.rfind("### `", 0) == 0) folder = kGenerator / line.substr(5, line.find('`', 5) - 5);
    if (folder.empty() || line.rfind("| ", 0) != 0) continue;
    std::istringstream rest(cells_of(line).back());
    for (std::string text, name; std::getline(rest, text, '`') && std::getline(rest, name, '`'); ++names)
      if (!fs::exists(folder / (name + ".hpp"))) FAIL_CHECK("there is no header of " << folder / name);
  }
  CHECK(names > 100);
}

TEST_CASE("the emulator includes only those folders of the generator that emulator/README.md allows it") {
  const std::set<std::string> listed = listed_for_emulator();
  const Included used = included_by_emulator();
  REQUIRE_FALSE(used.empty());
  for (const auto& [folder, file] : used) {
    if (!listed.contains(folder)) FAIL_CHECK(file << " includes '" << folder << "', which is not listed");
  }
  for (const std::string& folder : listed) {
    if (!used.contains(folder)) FAIL_CHECK("the emulator does not use '" << folder << "': take it from the list");
  }
}

TEST_CASE("arrows point up the page: a folder uses only folders listed before it") {
  const std::set<std::string> of_emulator = listed_for_emulator();
  std::set<std::string> before;
  for (const Row& row : listed_rows()) {
    // The emulator stands behind the last folder that it uses.
    if (std::includes(before.begin(), before.end(), of_emulator.begin(), of_emulator.end())) before.insert(kEmulator);
    for (const std::string& used : row.uses) {
      if (!before.contains(used))
        FAIL_CHECK("'" << row.folder << "' uses '" << used << "', which is not listed before it");
    }
    before.insert(row.folder);
  }
}

namespace {

/// Fails for every file below `folder` that includes one of `others`.
void check_apart(const std::string& folder, const std::vector<std::string>& others) {
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSources / folder)) {
    if (!is_source(entry.path())) continue;
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
