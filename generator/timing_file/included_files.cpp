#include "generator/timing_file/included_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Files at most: somebody may include a file of another name in every file.
constexpr std::size_t kMostFiles = 10'000;
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
  std::string text;
  bool is_quoted = false;  ///< else it is in brackets, and is not looked for beside the file
};

/// The name that a line `#include`s, or that it gives to a macro, which another line may include; nothing: it does
/// neither.
std::optional<Name> name_in(std::string_view line) {
  if (!skip(line, "#")) return std::nullopt;
  bool is_macro = false;
  if (skip(line, "define")) {
    is_macro = true;
    skip_spaces(line);
    line.remove_prefix(std::min(line.find_first_of(" \t"), line.size()));
  } else if (!skip(line, "include_next") && !skip(line, "include") && !skip(line, "import")) {
    return std::nullopt;
  }
  skip_spaces(line);
  if (line.empty() || (line.front() != '"' && line.front() != '<')) return std::nullopt;
  const bool is_quoted = line.front() == '"';
  const std::size_t end = line.find(is_quoted ? '"' : '>', 1);
  if (end == std::string_view::npos || end == 1) return std::nullopt;
  return Name{std::string(line.substr(1, end - 1)), is_quoted || is_macro};
}

std::vector<Name> names_in(const std::string& text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::vector<Name> names;
  std::istringstream lines(text.rfind(kByteOrderMark, 0) == 0 ? text.substr(kByteOrderMark.size()) : text);
  for (std::string line; std::getline(lines, line);) {
    if (auto name = name_in(line)) names.push_back(std::move(*name));
  }
  return names;
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
    if (name.is_quoted && !by.empty() && take(name.text, by.parent_path() / name.text)) return;
    for (const std::string& folder : folders_) {
      if (take(name.text, fs::path(folder) / name.text)) return;
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
  std::set<std::string> seen_;
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
