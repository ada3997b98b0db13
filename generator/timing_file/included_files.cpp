#include "generator/timing_file/included_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "generator/output/manifest.hpp"
#include "generator/timing_file/logical_lines.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Files at most: somebody may include a file of another name in every file.
constexpr std::size_t kMostFiles = 10'000;
/// Folders in each other: a link may lead back.
constexpr unsigned kMostLevels = 8;
/// Of a file: what is larger is data, and no source.
constexpr std::size_t kMostBytes = std::size_t{8} << 20;

void skip_spaces(std::string_view& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  line.remove_prefix(first == std::string_view::npos ? line.size() : first);
}

bool skip(std::string_view& line, std::string_view word) {
  skip_spaces(line);
  if (line.substr(0, word.size()) != word) return false;
  line.remove_prefix(word.size());
  return true;
}

struct Name {
  std::string text;        ///< empty: of any file, for nothing here tells which
  bool is_quoted = false;  ///< else it is in brackets, and is not looked for beside the file
};

/// The name that `text` begins with, in quotes or brackets.
std::optional<Name> quoted_name(std::string_view text, bool is_macro = false) {
  skip_spaces(text);
  if (text.empty() || (text.front() != '"' && text.front() != '<')) return std::nullopt;
  const bool is_quoted = text.front() == '"';
  const std::size_t end = text.find(is_quoted ? '"' : '>', 1);
  if (end == std::string_view::npos || end == 1) return std::nullopt;
  return Name{std::string(text.substr(1, end - 1)), is_quoted || is_macro};
}

/// What a condition asks for, of which the file depends whether it is there and what is in it.
void add_asked_for(std::string_view condition, std::vector<Name>& names) {
  constexpr std::string_view kAsks = "__has_include";
  for (std::size_t at = condition.find(kAsks); at != std::string_view::npos; at = condition.find(kAsks, at + 1)) {
    const std::size_t open = condition.find('(', at);
    if (open == std::string_view::npos) return;
    if (auto name = quoted_name(condition.substr(open + 1))) names.push_back(std::move(*name));
  }
}

/// The names that a line `#include`s or asks for, or that it gives to a macro, which another line may include.
void add_names_in(std::string_view line, std::vector<Name>& names) {
  if (!skip(line, "#") && !skip(line, "%:")) return;
  const bool is_macro = skip(line, "define");
  if (is_macro) {
    skip_spaces(line);
    line.remove_prefix(std::min(line.find_first_of(" \t"), line.size()));
  } else if (!skip(line, "include_next") && !skip(line, "include") && !skip(line, "import")) {
    return add_asked_for(line, names);
  }
  if (auto name = quoted_name(line, is_macro)) {
    names.push_back(std::move(*name));
  } else if (!is_macro && line.find('(') != std::string_view::npos) {
    names.emplace_back();  // what a macro makes of its arguments
  }
}

/// Whether an assembler reads further files.
bool reads_by_assembler(std::string_view text) {
  return text.find(".incbin") != std::string_view::npos || text.find(".include") != std::string_view::npos;
}

std::vector<Name> names_in(const std::string& text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::vector<Name> names;
  std::istringstream lines(logical_lines(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text));
  for (std::string line; std::getline(lines, line);) add_names_in(line, names);
  if (reads_by_assembler(text)) names.emplace_back();
  return names;
}

/// What FineMote writes where it is asked to: a timing file cannot be an input of itself.
bool is_result(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".json" || ending == ".html" || ending == ".svg";
}

class Search {
 public:
  Search(const std::vector<SourceText>& sources, const std::vector<std::string>& folders, const files::Access& access)
      : folders_(folders), access_(access) {
    for (const SourceText& source : sources) seen_.insert(real(source.path));
  }

  void look_through(const SourceText& source) {
    const fs::path by = source.path;  // finding may move `source`
    for (const Name& name : names_in(source.text)) find(name, by);
  }
  [[nodiscard]] const std::vector<SourceText>& found() const { return found_; }

 private:
  static std::string real(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(path, ignored).generic_string();
  }

  void find(const Name& name, const fs::path& by) {
    if (name.text.empty()) return take_all(by);
    if (name.is_quoted && !by.empty() && take(name.text, by.parent_path() / name.text)) return;
    for (const std::string& folder : folders_) {
      if (take(name.text, fs::path(folder) / name.text)) return;
    }
  }

  /// Every file beside the one that includes and in the folders, and below them.
  void take_all(const fs::path& by) {
    for (const std::string& folder : folders_) take_all_in(folder);
    if (!by.empty()) take_all_in(by.parent_path());
  }

  void take_all_in(const fs::path& folder) {
    if (looked_through_.insert(real(folder)).second) take_below(folder, {}, kMostLevels);
  }

  /// Made of the sources, as is what is below it: generated files, a build, the history.
  [[nodiscard]] bool is_product(const fs::path& folder) const {
    const auto has = [&](const char* name) { return !access_.why_not((folder / name).string()); };
    return folder.filename() == ".git" || has(kManifestName) || has("CMakeCache.txt");
  }

  void take_below(const fs::path& folder, const fs::path& way, unsigned levels_left) {
    files::Denial denial;
    for (const std::string& entry : access_.list((folder / way).string(), denial)) {
      const fs::path path = folder / way / entry;
      if (!access_.holds_folder(path.string())) {
        if (!is_result(path)) take((way / entry).generic_string(), path);
      } else if (levels_left > 0 && !is_product(path)) {
        take_below(folder, way / entry, levels_left - 1);
      }
    }
  }

  /// False: there is no such file.
  bool take(const std::string& name, const fs::path& path) {
    if (access_.why_not(path.string())) return false;
    if (found_.size() == kMostFiles || !seen_.insert(real(path)).second) return true;
    std::string text =
        access_.read(path.string(), kMostBytes).value_or(std::string());  // empty: larger than any source
    found_.push_back({name, path.string(), std::move(text)});
    return true;
  }

  const std::vector<std::string>& folders_;
  const files::Access& access_;
  std::set<std::string> seen_, looked_through_;
  std::vector<SourceText> found_;
};

}  // namespace

bool has_source_name(const std::string& name) {
  static constexpr std::array<std::string_view, 18> kEndings = {".h",   ".hh",  ".hpp", ".hxx", ".H", ".ipp",
                                                                ".inl", ".tpp", ".inc", ".def", ".c", ".cc",
                                                                ".cpp", ".cxx", ".C",   ".s",   ".S", ".ld"};
  const std::string ending = fs::path(name).extension().string();
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::vector<SourceText> included_files(const std::vector<SourceText>& sources, const std::vector<std::string>& folders,
                                       const files::Access& access) {
  Search search(sources, folders, access);
  for (const SourceText& source : sources) search.look_through(source);
  for (std::size_t i = 0; i < search.found().size(); ++i) search.look_through(search.found()[i]);
  return search.found();
}

}  // namespace finemote::gen
