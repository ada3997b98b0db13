#include "generator/report/page.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "generator/file/installed_file.hpp"
#include "generator/graph/forest_svg.hpp"
#include "generator/output/sha256.hpp"
#include "generator/report/base64.hpp"
#include "generator/report/changes.hpp"
#include "generator/report/data_block.hpp"
#include "generator/report/over_time.hpp"
#include "generator/report/tables.hpp"
#include "generator/report/verdict.hpp"
#include "generator/svg/palette.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

/// Of the page, in the order in which they run; templates/README.md says what each does.
constexpr const char* kScripts[] = {
    "page.js", "chains.js", "timeline_data.js", "way.js", "timeline_table.js", "timeline.js", "main.js",
};

/// Class and mark of a verdict, in the order of Verdict::Look.
constexpr std::pair<const char*, const char*> kLooks[] = {{"good", "✓"}, {"open", "!"}, {"bad", "✗"}};

/// The pieces of a page, by the names that stand for them in page.html between two `@`.
using Pieces = std::map<std::string, std::string>;

std::string filled(const std::string& frame, const Pieces& pieces) {
  std::string page;
  std::size_t at = 0;
  for (std::size_t begin = frame.find('@'); begin != std::string::npos; begin = frame.find('@', at)) {
    const std::size_t end = frame.find('@', begin + 1);
    page.append(frame, at, begin - at).append(pieces.at(frame.substr(begin + 1, end - begin - 1)));
    at = end + 1;
  }
  return page.append(frame, at);
}

std::string style_of(const std::string& folder) {
  return fmt::format(
             ":root {{\n{0}}}\n@media (prefers-color-scheme: dark) {{\n:root:not([data-theme=light]) {{\n{1}}}\n}}\n"
             ":root[data-theme=dark] {{\n{1}}}\n@media print {{\n:root:root:root {{\n{0}}}\n}}\n",
             svg::kLightColours, svg::kDarkColours) +
         kForestStyle + read_installed(folder + "/style.css");
}

std::string script_of(const std::string& folder) {
  std::string text = "'use strict';\n";
  for (const char* name : kScripts) text += read_installed(folder + "/" + name);
  return text;
}

/// A section that not every report has, with the link to it.
void add_optional(const std::string& name, const std::string& title, const std::string& text, Pieces& pieces) {
  const bool is_there = !text.empty();
  pieces[name + "_link"] = is_there ? fmt::format("<a href=\"#{}\">{}</a>\n", name, title) : "";
  pieces[name] = is_there ? fmt::format(
                                "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n"
                                "<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
                                name, title, text)
                          : "";
}

/// After what the order of releases begins anew.
std::string repeats_text(const Documents& documents) {
  const Place hyperperiod = documents.of_simulation()["hyperperiod_ns"];
  if (!hyperperiod.is_number()) return "Releases fall together anew only after centuries.";
  return "Releases fall together anew every " + hyperperiod.figure(Unit::time) + ".";
}

}  // namespace

std::string page_of(const Contents& contents, const std::string& folder) {
  const auto& [view, body, model, documents, timeline] = contents;
  const Verdict verdict = verdict_of(documents, view.robot);
  const std::string script = script_of(folder);
  Pieces pieces;
  pieces["title"] = svg::escaped(view.robot);
  pieces["board"] = svg::escaped(fmt::format("{}, tick {}", view.board, view.tick));
  pieces["rests_on"] = svg::escaped(rests_on(documents));
  pieces["script_hash"] = base64_of_hex(sha256(script));
  pieces["style"] = style_of(folder);
  pieces["script"] = script;
  pieces["verdict"] = svg::escaped(verdict.text);
  pieces["verdict_look"] = kLooks[static_cast<std::size_t>(verdict.look)].first;
  pieces["verdict_mark"] = kLooks[static_cast<std::size_t>(verdict.look)].second;
  pieces["figures"] = headline_figures(documents);
  pieces["forest"] = inline_forest_svg(view);
  pieces["devices"] = device_table(documents, view);
  pieces["chains"] = chain_table(documents, model);
  pieces["earlier"] = earlier_bounds(documents);
  pieces["requirements"] = requirement_table(documents);
  pieces["length"] = shown(timeline.length.ns(), Unit::time);
  pieces["simulated"] = documents.of_simulation()["duration_ns"].figure(Unit::time);
  pieces["repeats"] = repeats_text(documents);
  pieces["processor"] = processor_table(documents);
  pieces["buses"] = bus_table(documents);
  pieces["assumptions"] = assumption_table(documents);
  pieces["data"] = data_block(model, timeline, documents.of_timing()["profile"].text());
  add_optional("changes", "What changed", changes_of(documents), pieces);
  add_optional("run", "The run over time", over_time(documents), pieces);
  add_optional("image", "Flash and RAM", image_table(documents), pieces);
  add_optional("body", "The robot from three sides", body_pictures(body), pieces);
  return filled(read_installed(folder + "/page.html"), pieces);
}

}  // namespace finemote::gen::report
