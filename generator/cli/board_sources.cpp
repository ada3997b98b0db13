// finemote board sources: what the runtime compiles for a board, made of its file.
#include "generator/board_sources/board_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/board_sources/chip_needs.hpp"
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/named_board.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// The boards that others stand in for, by name; a wrong one is reported.
std::vector<const Board*> real_boards(Library& library, Sources& sources, Diagnostics& diagnostics) {
  std::vector<const Board*> boards;
  for (const std::string& name : board_names(library)) {
    const Board* board = find_board(library, name, sources, diagnostics);
    if (board != nullptr && !board->stands_in) boards.push_back(board);
  }
  return boards;
}

/// FM3103 for each, at the begin of the board's file.
void report_mistakes(const Board& board, const std::vector<std::string>& mistakes, const Sources& sources,
                     Diagnostics& diagnostics) {
  Position at;
  for (const SourceFile& file : sources.files()) {
    if (file.name == board.display_path) at = {&file, 1, 1, nullptr};
  }
  for (const std::string& mistake : mistakes)
    diagnostics.error(code::descriptor_contradiction, at, fmt::format("board '{}': {}", board.name, mistake));
}

/// Whether a file is one of this command's: its second line names a board file, which nothing else generated does.
bool is_board_source(const std::string& text) {
  const std::size_t first_end = text.find('\n');
  if (first_end == std::string::npos) return false;
  const std::string second = text.substr(first_end + 1, text.find('\n', first_end + 1) - first_end - 1);
  const std::size_t source = second.find("Source: ");
  return text.substr(0, first_end) == kGeneratedHeader && source != std::string::npos &&
         second.find(".json", source) != std::string::npos;
}

/// Ports of an older board file: sources in the folder of ports that are none of `files`.
std::vector<std::string> left_over(const fs::path& folder, const std::vector<OutputFile>& files) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / "ports", ignored)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    const bool is_made =
        std::any_of(files.begin(), files.end(), [&](const OutputFile& file) { return file.name == name; });
    if (is_made || !entry.is_regular_file(ignored)) continue;
    const auto text = read_bytes(entry.path().string());
    if (text && is_board_source(*text)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool write(const fs::path& folder, const OutputFile& file, Diagnostics& diagnostics) {
  const fs::path path = folder / file.name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (!error) return write_result(path.generic_string(), file.text, diagnostics);
  report_unwritten(path.generic_string(), system_reason(error.value()), diagnostics);
  return false;
}

/// What a folder of sources holds other than it should.
struct Difference {
  std::vector<std::string> different;  ///< files that are missing or say something else
  std::vector<std::string> left_over;
};

Difference difference_of(const fs::path& folder, const std::vector<OutputFile>& files) {
  Difference difference{{}, left_over(folder, files)};
  for (const OutputFile& file : files) {
    if (read_bytes((folder / file.name).string()) != file.text) difference.different.push_back(file.name);
  }
  return difference;
}

/// Writes what differs and removes what is left over. @return false: it did not succeed, which was reported
bool bring_up_to_date(const fs::path& folder, const std::vector<OutputFile>& files, const Difference& difference,
                      Diagnostics& diagnostics) {
  for (const OutputFile& file : files) {
    const bool differs =
        std::find(difference.different.begin(), difference.different.end(), file.name) != difference.different.end();
    if (differs && !write(folder, file, diagnostics)) return false;
  }
  for (const std::string& name : difference.left_over) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (!error) continue;
    report_unwritten((folder / name).generic_string(), system_reason(error.value()), diagnostics);
    return false;
  }
  return true;
}

Answer answer_of(const Board& board, const Difference& difference, bool dry_run) {
  Answer answer{kExitYes};
  for (const std::string& name : difference.different) answer.text += (dry_run ? "stale: " : "written: ") + name + "\n";
  for (const std::string& name : difference.left_over)
    answer.text += (dry_run ? "left over: " : "removed: ") + name + "\n";
  const bool is_current = difference.different.empty() && difference.left_over.empty();
  if (dry_run && !is_current) answer.status = kExitNo;
  answer.document = {{"schema", "finemote.board-sources/1"},
                     {"board", board.name},
                     {"different", difference.different},
                     {"left_over", difference.left_over}};
  return answer;
}

}  // namespace

Answer run_board_sources(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  auto library = load_library({data_dir, "", {}, {}}, sources, diagnostics);
  if (!library) return no_answer();
  const Board* board = named_board(options.input, *library, sources, diagnostics);
  const std::vector<const Board*> boards = real_boards(*library, sources, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  for (const Board* used : board->stands_in ? boards : std::vector<const Board*>{board})
    report_mistakes(*used, mistakes_for_chip(*used), sources, diagnostics);
  report_mistakes(*board, mistakes_for_sources(*board, boards), sources, diagnostics);
  if (diagnostics.has_errors()) return no_answer();

  const std::vector<OutputFile> files = board_sources(*board, boards, data_dir);
  const Difference difference = difference_of(options.out, files);
  if (!options.dry_run && !bring_up_to_date(options.out, files, difference, diagnostics)) return no_answer();
  return answer_of(*board, difference, options.dry_run);
}

}  // namespace finemote::gen
