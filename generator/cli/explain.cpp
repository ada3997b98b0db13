// finemote explain: the page of a diagnostic.
#include <fmt/format.h>

#include <algorithm>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

Answer list_pages(const std::vector<CatalogueEntry>& pages) {
  Answer answer{kExitYes};
  Json list = Json::array();
  for (const CatalogueEntry& page : pages) {
    const std::string name = code_name(page.code);
    answer.text += name + "  " + page.title + "\n";
    list.push_back({{"code", name}, {"title", page.title}});
  }
  answer.document = {{"schema", "finemote.explain/1"}, {"codes", list}};
  return answer;
}

std::vector<std::string> names_of(const std::vector<CatalogueEntry>& pages) {
  std::vector<std::string> names;
  for (const CatalogueEntry& page : pages) names.push_back(code_name(page.code));
  return names;
}

}  // namespace

Answer run_explain(const Options& options, Sources& /*sources*/, Diagnostics& diagnostics) {
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  const std::string folder = data_dir + "/diagnostics";
  const std::vector<CatalogueEntry> pages = list_catalogue(folder);
  if (options.input.empty()) return list_pages(pages);
  const auto code = parse_code(options.input);  // `FM3012`, `fm3012`, or `3012`, as `lint --allow` takes it
  const std::string wanted = code ? code_name(*code) : options.input;
  const std::vector<std::string> names = names_of(pages);
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
