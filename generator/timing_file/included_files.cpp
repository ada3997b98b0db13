#include "generator/timing_file/included_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "generator/output/manifest.hpp"
#include "generator/timing_file/directives.hpp"
#include "generator/timing_file/standard_headers.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Files at most: somebody may include a file of another name in every file.
constexpr std::size_t kMostFiles = 10'000;
/// Folders in each other: a link may lead back.
constexpr unsigned kMostLevels = 32;
/// Of a file: what is larger is data, and no source.
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

/// What FineMote writes where it is asked to.
bool is_result(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".json" || ending == ".html" || ending == ".svg";
}

/// A timing file cannot be an input of itself.
bool is_timing_file(const fs::path& file) {
  constexpr std::string_view kEnding = ".timing.json";
  const std::string name = file.filename().string();
  return name.size() > kEnding.size() && name.substr(name.size() - kEnding.size()) == kEnding;
}

/// What counts of all that lies in a folder.
enum class Any { source, file, raw };

class Search {
 public:
  Search(const std::vector<SourceText>& sources, const std::vector<std::string>& folders, const files::Access& access)
      : folders_(folders), access_(access) {
    for (const SourceText& source : sources) seen_.insert(place(source.path));
  }

  void look_through(const SourceText& source) {
    const fs::path by = source.path;  // finding may move `source`
    const Directives found = directives_of(source.text);
    for (const FileName& name : found.names) find(name, by);
    for (const std::string& macro : found.computed) computed_.emplace_back(macro, by);
    for (const auto& [macro, files] : found.macros) macros_[macro].insert(files.begin(), files.end());
    has_pasted_ |= found.has_pasted;
    if (found.asks_macro) askers_.push_back(by);
    if (found.asks_for_any) take_all(by, Any::file);
    if (found.is_read_by_assembler) take_all(by, Any::raw);
  }

  /// Files that others have under names of their own, and that are found before those.
  void look_for_names_of(const SourceText& shipped) {
    for (const FileName& name : directives_of(shipped.text).names) find(name, {});
  }

  /// The same of headers of the compiler, which include others of these.
  void look_for_standard_names() {
    for (const std::string_view name : kStandardHeaders) find({std::string(name), false, false, true}, {});
    for (const std::string& folder : folders_) {
      for (const std::string_view below : kStandardFolders) take_all_in(fs::path(folder) / below, Any::source);
    }
  }

  /// What macros make names of, once all of them are known: what they say, beside the line that includes it, too, or it
  /// may be any.
  void take_computed() {
    for (const auto& [macro, by] : std::exchange(computed_, {})) {
      const auto known = macros_.find(macro);
      if (known == macros_.end() || known->second.count({}) != 0) {
        take_all(by, Any::source);
        continue;
      }
      for (const std::string& file : known->second) find({file, true, false}, by);
    }
    if (!has_pasted_) return;
    for (const fs::path& by : std::exchange(askers_, {})) take_all(by, Any::file);  // as by __has_ ## include
  }

  [[nodiscard]] const std::vector<SourceText>& found() const { return found_; }
  [[nodiscard]] std::vector<SourceText> result() {
    for (SourceText& source : found_) source.is_raw = raw_.count(real(source.path)) != 0;
    return std::move(found_);
  }

 private:
  static std::string real(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(path, ignored).generic_string();
  }

  /// A file, and where a link has it: the compiler looks for others beside that.
  static std::pair<std::string, std::string> place(const fs::path& path) {
    return {real(path), real(path.parent_path())};
  }

  void find(const FileName& name, const fs::path& by) {
    const std::string folder_of = by.parent_path().generic_string();
    const bool is_new = asked_.emplace(name.text, name.is_quoted ? folder_of : std::string()).second;
    if (!is_new && !name.is_raw && !name.is_next) return;
    const auto take_in = [&](const fs::path& folder) {
      return take(name.text, folder / name.text, name.is_raw) && !name.is_next;
    };
    if (name.is_quoted && !by.empty() && take_in(by.parent_path())) return;
    for (const std::string& folder : folders_) {
      if (take_in(folder)) return;
    }
  }

  /// Every file beside the one that includes and in the folders, and below them.
  void take_all(const fs::path& by, Any any) {
    for (const std::string& folder : folders_) take_all_in(folder, any);
    if (!by.empty()) take_all_in(by.parent_path(), any);
  }

  void take_all_in(const fs::path& folder, Any any) {
    if (looked_through_.emplace(real(folder), any).second) take_below(folder, {}, any, kMostLevels);
  }

  /// Made of the sources, as is what is below it: generated files, a build, the history.
  [[nodiscard]] bool is_product(const fs::path& folder) const {
    const auto has = [&](const char* name) { return !access_.why_not((folder / name).string()); };
    return folder.filename() == ".git" || has(kManifestName) || has("CMakeCache.txt");
  }

  void take_below(const fs::path& folder, const fs::path& way, Any any, unsigned levels_left) {
    files::Denial denial;
    for (const std::string& entry : access_.list((folder / way).string(), denial)) {
      const fs::path path = folder / way / entry;
      if (!access_.holds_folder(path.string())) {
        if (any == Any::source ? !is_result(path) : !is_timing_file(path))
          take((way / entry).generic_string(), path, any == Any::raw);
      } else if (levels_left > 0 && !is_product(path)) {
        take_below(folder, way / entry, any, levels_left - 1);
      }
    }
  }

  /// False: there is no such file.
  bool take(const std::string& name, const fs::path& path, bool is_raw) {
    if (access_.why_not(path.string())) return false;
    if (is_raw) raw_.insert(real(path));
    if (!seen_.insert(place(path)).second) return true;
    if (found_.size() == kMostFiles) {
      found_.back().is_whole = false;
      return true;
    }
    auto text = access_.read(path.string(), kMostBytes);
    const bool is_whole = text.has_value();
    found_.push_back({name, path.string(), std::move(text).value_or(std::string()), false, is_whole});
    if (!is_raw) take_compiled(name, path);
    return true;
  }

  /// What the compiler reads in place of a header: one file of that name, or any in a folder of it.
  void take_compiled(const std::string& name, const fs::path& path) {
    constexpr const char* kEnding = ".gch";
    const fs::path compiled = path.string() + kEnding;
    if (access_.holds_folder(compiled.string())) return take_all_in(compiled, Any::raw);
    take(name + kEnding, compiled, true);
  }

  const std::vector<std::string>& folders_;
  const files::Access& access_;
  std::set<std::pair<std::string, std::string>> seen_;
  std::set<std::string> raw_;
  std::set<std::pair<std::string, Any>> looked_through_;
  std::set<std::pair<std::string, std::string>> asked_;  ///< names, and the folders of those who ask
  std::vector<std::pair<std::string, fs::path>> computed_;
  std::map<std::string, std::set<std::string>> macros_;
  std::vector<fs::path> askers_;  ///< whose conditions have macros with arguments
  bool has_pasted_ = false;
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

std::vector<SourceText> included_files(const std::vector<SourceText>& sources, const std::vector<SourceText>& shipped,
                                       const std::vector<std::string>& folders, const files::Access& access) {
  Search search(sources, folders, access);
  for (const SourceText& source : shipped) search.look_for_names_of(source);
  search.look_for_standard_names();
  for (const SourceText& source : sources) search.look_through(source);
  for (std::size_t i = 0;; ++i) {
    if (i == search.found().size()) search.take_computed();
    if (i == search.found().size()) return search.result();
    search.look_through(search.found()[i]);
  }
}

}  // namespace finemote::gen
