// finemote docs: the reference pages that are made from descriptors, board files and the rules of lint.
#include <fmt/format.h>

#include <filesystem>

#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/code_output.hpp"
#include "generator/document/board_page.hpp"
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
  Pages(Context& context) : context_(context), folder_(context.options.out) {}

  /// Takes a page whose made part differs from the file's. Reports FM5004 for a file without such a part.
  void add(const std::string& name, const std::string& title, const std::string& made) {
    const std::string path = (folder_ / name).generic_string();
    const auto old = read_bytes(path);
    const std::string text = with_made_part(old, "# " + title, made);
    if (old == text) return;
    if (old && !has_made_part(*old)) {
      context_.diagnostics
          .error(code::file_of_the_user, {context_.sources.add({path, path, {}})},
                 fmt::format("'{}' was not written by finemote and would be overwritten", name))
          .hint("move it elsewhere, or give another folder with -o");
      return;
    }
    different_.push_back({name, text});
  }

  /// Reports pages that are one file with another, or with what was read.
  void check() {
    std::vector<PlannedFile> planned;
    for (const OutputFile& page : different_) planned.push_back({(folder_ / page.name).generic_string(), "-o"});
    check_outputs(planned, context_.sources, context_.diagnostics);
  }

  void write() {
    for (const OutputFile& page : different_) {
      const fs::path path = folder_ / page.name;
      std::error_code error;
      fs::create_directories(path.parent_path(), error);
      if (error) return report_unwritten(context_, path.generic_string(), system_reason(error.value()));
      if (!write_result(context_, path.generic_string(), page.text)) return;
    }
  }

  [[nodiscard]] std::vector<std::string> different() const {
    std::vector<std::string> names;
    for (const OutputFile& page : different_) names.push_back(page.name);
    return names;
  }

 private:
  Context& context_;
  fs::path folder_;
  std::vector<OutputFile> different_;
};

}  // namespace

int run_docs(Context& context) {
  const std::string data_dir = find_data_dir(context.options, context.diagnostics);
  if (data_dir.empty()) return finish(context, kExitInvalid);
  auto library = load_library({data_dir, "", {}, {}}, context.sources, context.diagnostics);
  if (!library) return finish(context, kExitInvalid);
  Pages pages(context);
  for (const std::string& name : device_type_names(*library)) {
    const DeviceType* type = find_device_type(*library, name, context.sources, context.diagnostics);
    if (type != nullptr) pages.add("devices/" + name + ".md", "`" + name + "`", device_page(*type));
  }
  for (const std::string& name : board_names(*library)) {
    const Board* board = find_board(*library, name, context.sources, context.diagnostics);
    if (board == nullptr || !board->has_watchdog) continue;  // no hardware
    for (const BoardPage& page : board_pages(*board))
      pages.add(fmt::format("boards/{}/{}.md", name, page.name), page.title, page.text);
  }
  pages.add("lint.md", "Findings of lint", lint_page());
  pages.check();
  if (!context.options.dry_run && !context.diagnostics.has_errors()) pages.write();
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  if (context.options.format == Format::text) {
    for (const std::string& name : pages.different())
      context.out << (context.options.dry_run ? "stale: " : "written: ") << name << "\n";
  }
  const bool stale = context.options.dry_run && !pages.different().empty();
  return finish(context, stale ? kExitNo : kExitYes,
                Json{{"schema", "finemote.docs/1"}, {"different", pages.different()}});
}

}  // namespace finemote::gen
