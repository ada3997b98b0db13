// finemote docs: the reference pages that are made from descriptors, board files and the rules of lint.
#include <fmt/format.h>

#include <filesystem>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/code_output.hpp"
#include "generator/document/board_page.hpp"
#include "generator/document/connector_page.hpp"
#include "generator/document/device_page.hpp"
#include "generator/document/lint_page.hpp"
#include "generator/document/markdown.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Pages below a folder: collected first, so that all of them or none are written.
class Pages {
 public:
  Pages(fs::path folder, Sources& sources, Diagnostics& diagnostics)
      : folder_(std::move(folder)), sources_(sources), diagnostics_(diagnostics) {}

  /// Takes a page whose made part differs from the file's. Reports FM5004 for a file without such a part.
  void add(const std::string& name, const std::string& title, const std::string& made) {
    const auto old = read_bytes((folder_ / name).generic_string());
    take(name, old, with_made_part(old, "# " + title, made));
  }

  /// The same for a picture, which is made as a whole.
  void add_picture(const std::string& name, const std::string& svg) {
    take(name, read_bytes((folder_ / name).generic_string()), as_made(svg));
  }

  /// Reports pages that are one file with another, or with what was read.
  void check() {
    std::vector<PlannedFile> planned;
    for (const OutputFile& page : different_) planned.push_back({(folder_ / page.name).generic_string(), "-o"});
    check_outputs(planned, sources_, diagnostics_);
  }

  void write() {
    for (const OutputFile& page : different_) {
      const fs::path path = folder_ / page.name;
      std::error_code error;
      fs::create_directories(path.parent_path(), error);
      if (error) return report_unwritten(path.generic_string(), system_reason(error.value()), diagnostics_);
      if (!write_result(path.generic_string(), page.text, diagnostics_)) return;
    }
  }

  [[nodiscard]] std::vector<std::string> different() const {
    std::vector<std::string> names;
    for (const OutputFile& page : different_) names.push_back(page.name);
    return names;
  }

 private:
  void take(const std::string& name, const std::optional<std::string>& old, const std::string& text) {
    if (old == text) return;
    if (!old || has_made_part(*old)) return different_.push_back({name, text});
    const std::string path = (folder_ / name).generic_string();
    diagnostics_
        .error(code::file_of_the_user, {sources_.add({path, path, {}})},
               fmt::format("'{}' was not written by finemote and would be overwritten", name))
        .hint("move it elsewhere, or give another folder with -o");
  }

  fs::path folder_;
  Sources& sources_;
  Diagnostics& diagnostics_;
  std::vector<OutputFile> different_;
};

/// Adds the page of every device type, those of every board with hardware, and that of lint.
void add_pages(Library& library, Pages& pages, Sources& sources, Diagnostics& diagnostics) {
  for (const std::string& name : device_type_names(library)) {
    const DeviceType* type = find_device_type(library, name, sources, diagnostics);
    if (type != nullptr) pages.add("devices/" + name + ".md", "`" + name + "`", device_page(*type));
  }
  for (const std::string& name : board_names(library)) {
    const Board* board = find_board(library, name, sources, diagnostics);
    if (board == nullptr || !board->has_watchdog) continue;  // no hardware
    for (const BoardPage& page : board_pages(*board))
      pages.add(fmt::format("boards/{}/{}.md", name, page.name), page.title, page.text);
    for (const Picture& picture : connector_pictures(*board))
      pages.add_picture(fmt::format("boards/{}/{}", name, picture.name), picture.svg);
  }
  pages.add("lint.md", "Findings of lint", lint_page());
}

}  // namespace

Answer run_docs(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  auto library = load_library({data_dir, "", {}, {}}, sources, diagnostics);
  if (!library) return no_answer();
  Pages pages(options.out, sources, diagnostics);
  add_pages(*library, pages, sources, diagnostics);
  pages.check();
  if (!options.dry_run && !diagnostics.has_errors()) pages.write();
  if (diagnostics.has_errors()) return no_answer();
  const std::vector<std::string> different = pages.different();
  Answer answer{options.dry_run && !different.empty() ? kExitNo : kExitYes};
  for (const std::string& name : different) answer.text += (options.dry_run ? "stale: " : "written: ") + name + "\n";
  answer.document = {{"schema", "finemote.docs/1"}, {"different", different}};
  return answer;
}

}  // namespace finemote::gen
