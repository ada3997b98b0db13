// finemote explain: the page of a diagnostic.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Names of all pages, `FM0001` and so on, sorted.
std::vector<std::string> page_names(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().stem().string();
    if (name.rfind("FM", 0) == 0 && entry->path().extension() == ".md") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// `the board has no such port`, of a page that begins `# FM3012: the board has no such port`.
std::string title_of(const std::string& page) {
  const auto colon = page.find(": ");
  const auto end = page.find('\n');
  return colon == std::string::npos || colon > end ? std::string() : page.substr(colon + 2, end - colon - 2);
}

Answer list_pages(const std::string& folder, const std::vector<std::string>& names) {
  Answer answer{kExitYes};
  Json list = Json::array();
  for (const std::string& name : names) {
    const std::string title = title_of(read_bytes(folder + "/" + name + ".md").value_or(""));
    answer.text += name + "  " + title + "\n";
    list.push_back({{"code", name}, {"title", title}});
  }
  answer.document = {{"schema", "finemote.explain/1"}, {"codes", list}};
  return answer;
}

}  // namespace

Answer run_explain(const Options& options, Sources& /*sources*/, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  const std::string folder = data_dir + "/diagnostics";
  const std::vector<std::string> names = page_names(folder);
  if (options.input.empty()) return list_pages(folder, names);
  const auto code = parse_code(options.input);  // `FM3012`, `fm3012`, or `3012`, as `lint --allow` takes it
  const std::string wanted = code ? code_name(*code) : options.input;
  if (std::find(names.begin(), names.end(), wanted) == names.end()) {
    diagnostics.error(code::usage, {}, fmt::format("there is no diagnostic '{}'", options.input))
        .hint(did_you_mean(wanted, names));
    return no_answer();
  }
  const auto page = read_data_file(folder + "/" + wanted + ".md", diagnostics);
  if (!page) return no_answer();
  return {kExitYes, *page,
          Json{{"schema", "finemote.explain/1"}, {"code", wanted}, {"title", title_of(*page)}, {"page", *page}}};
}

}  // namespace finemote::gen
