#include "generator/timing_file/inputs_hash.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "generator/output/manifest.hpp"
#include "generator/output/sha256.hpp"
#include "generator/timing_file/logical_lines.hpp"
#include "generator/timing_file/timing_file.hpp"
#include "generator/timing_file/user_code.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// What the runtime is compiled with.
constexpr const char* kBuildFiles[] = {"FinemoteCompile.cmake", "FinemoteFirmware.cmake",
                                       "toolchain-arm-none-eabi.cmake"};

constexpr int kDeepest = 32;

/// Without the lines that name what the file was made from.
std::string without_sources(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("// Source:", 0) != 0) kept += line + "\n";
  }
  return kept;
}

/// A file; empty: it cannot be read.
SourceText source_at(const std::string& name, const fs::path& path, const files::Access& access) {
  return {name, path.string(), access.read(path.string(), xml::kMaxFileSize).value_or(std::string())};
}

/// Every source below a folder, in the order of names. Generated folders and hidden ones are left out: they hold what
/// is made of the robot.
void collect(const std::string& name, const fs::path& folder, const files::Access& access,
             std::vector<SourceText>& sources, int depth = 0) {
  files::Denial denial;
  std::vector<std::string> entries = access.list(folder.string(), denial);
  const bool is_generated = std::find(entries.begin(), entries.end(), kManifestName) != entries.end();
  if (is_generated || depth == kDeepest) return;
  for (const std::string& entry : entries) {
    if (entry.empty() || entry.front() == '.') continue;
    const fs::path path = folder / entry;
    if (access.holds_folder(path.string())) {
      collect(name + "/" + entry, path, access, sources, depth + 1);
    } else if (has_source_name(entry)) {
      sources.push_back(source_at(name + "/" + entry, path, access));
    }
  }
}

/// Names and digests of files, one after the other.
class List {
 public:
  void add(const std::string& name, const std::string& text) { text_ += name + " " + sha256(text) + "\n"; }

  void add(const std::vector<SourceText>& sources) {
    for (const SourceText& source : sources) add(source.name, source.text);
  }

  [[nodiscard]] std::string digest() const { return sha256(text_); }

 private:
  std::string text_;
};

std::vector<SourceText> shipped_sources(const fs::path& data, const std::string& board) {
  const files::Access own;  // what is shipped lies outside of every sandbox
  std::vector<SourceText> sources;
  for (const char* folder : {"chips", "devices", "include", "src"})
    collect(std::string("runtime/") + folder, data / "runtime" / folder, own, sources);
  collect("runtime/board", data / "runtime" / "boards" / board, own, sources);
  for (const char* file : kBuildFiles) sources.push_back(source_at(file, data / "cmake" / file, own));
  return sources;
}

/// What an assembler reads stays as it is.
std::vector<SourceText> with_common_ends(std::vector<SourceText> sources) {
  for (SourceText& source : sources) {
    if (!source.is_raw) source.text = without_returns(source.text);
  }
  return sources;
}

}  // namespace

TimingState timing_state(const TimingInputs& inputs, const files::Access& access) {
  List list;
  const CostModel model = cost_model();
  list.add("model", model.name + " " + std::to_string(model.version));
  list.add("board", inputs.board + " " + inputs.placement);
  for (const OutputFile& file : inputs.generated) list.add(file.name, without_sources(file.text));
  const std::vector<SourceText> shipped = shipped_sources(inputs.data_dir, inputs.board);
  list.add(shipped);
  const std::vector<SourceText> user = user_code(inputs.generated, shipped, inputs.user_folders, access);
  list.add(with_common_ends(user));
  const bool is_whole = std::all_of(user.begin(), user.end(), [](const SourceText& file) { return file.is_whole; });
  TimingState state{is_whole ? list.digest() : std::string(), {}};
  for (const SourceText& source : user) state.user_files.push_back(source.path);
  return state;
}

std::string shipped_digest(const std::string& data_dir, const std::string& board) {
  List list;
  list.add(shipped_sources(data_dir, board));
  return list.digest();
}

}  // namespace finemote::gen
