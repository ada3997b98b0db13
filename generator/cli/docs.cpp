// finemote docs: the reference pages that are made from descriptors and board files.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/document/board_page.hpp"
#include "generator/document/device_page.hpp"
#include "generator/document/markdown.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Writes pages below a folder, or only compares them.
class PageWriter {
 public:
  PageWriter(Context& context) : context_(context), folder_(context.options.out) {}

  void write(const std::string& name, const std::string& title, const std::string& made) {
    const fs::path path = folder_ / name;
    const auto old = read_bytes(path.string());
    const std::string text = with_made_part(old, "# " + title, made);
    if (old == text) return;
    different_.push_back(name);
    if (context_.options.format == Format::text)
      context_.out << (context_.options.dry_run ? "stale: " : "written: ") << name << "\n";
    if (context_.options.dry_run) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::ofstream file(path, std::ios::binary);
    if (!(file << text) || error)
      context_.diagnostics.error(code::output_not_writable, {},
                                 fmt::format("cannot write '{}'", path.generic_string()));
  }
  [[nodiscard]] const std::vector<std::string>& different() const { return different_; }

 private:
  Context& context_;
  fs::path folder_;
  std::vector<std::string> different_;
};

}  // namespace

int run_docs(Context& context) {
  const std::string data_dir = find_data_dir(context.options, context.diagnostics);
  if (data_dir.empty()) return finish(context, kExitInvalid);
  auto library = load_library({data_dir, "", {}, {}}, context.sources, context.diagnostics);
  if (!library) return finish(context, kExitInvalid);
  PageWriter pages(context);
  for (const std::string& name : device_type_names(*library)) {
    const DeviceType* type = find_device_type(*library, name, context.sources, context.diagnostics);
    if (type != nullptr)
      pages.write("devices/" + name + ".md", "`" + name + "`", device_page(*type->descriptor, type->include));
  }
  for (const std::string& name : board_names(*library)) {
    const Board* board = find_board(*library, name, context.sources, context.diagnostics);
    if (board == nullptr || board->file->value("watchdog", Json()).is_null()) continue;  // no hardware
    for (const BoardPage& page : board_pages(*board->file))
      pages.write(fmt::format("boards/{}/{}.md", name, page.name), page.title, page.text);
  }
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  const bool stale = context.options.dry_run && !pages.different().empty();
  return finish(context, stale ? kExitNo : kExitYes,
                Json{{"schema", "finemote.docs/1"}, {"different", pages.different()}});
}

}  // namespace finemote::gen
