#include <fmt/format.h>

#include <map>

#include "generator/report/path.hpp"
#include "generator/report/table.hpp"
#include "generator/report/tables.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

std::string places(const std::vector<Rank>& devices) {
  std::string text;
  for (const Rank device : devices) text += (text.empty() ? "" : " ") + std::to_string(device.value());
  return text;
}

std::map<std::string, Rank> ranks_of(const timing::Model& model) {
  std::map<std::string, Rank> ranks;
  for (const Rank d : model.devices.ids()) ranks.emplace(model.devices[d].name, d);
  return ranks;
}

/// Why a part has no bound, and what gives it one.
std::string gap_text(const Place& gap) {
  std::string text = "no bound of " + gap["part"].text() + ": " + gap["why"].text();
  for (std::size_t i = 0; i < gap["restored_by"].size(); ++i)
    text += (i == 0 ? "; restored by " : ", or by ") + gap["restored_by"][i].text();
  return text;
}

std::string remarks(const Place& chain) {
  std::string text;
  const auto add = [&](const std::string& remark) { text += (text.empty() ? "" : "; ") + remark; };
  if (chain["assumed"].is_true()) add("rests on assumed execution times");
  if (chain["through_reads"].is_true()) add("through <reads>");
  if (chain["closed_form"].is_true()) add("by a simpler formula, never below the exact one");
  for (std::size_t i = 0; i < chain["unbounded"].size(); ++i) add(gap_text(chain["unbounded"][i]));
  return text;
}

std::vector<Column> columns_of(bool has_run) {
  std::vector<Column> columns{{"Chain"},      {"Acquire", true},    {"Decide", true},
                              {"Wire", true}, {"End to end", true}, {"Decide, simulated", true}};
  if (has_run) {
    for (const char* title : {"Acquire, measured", "Decide, measured", "Wire, measured", "End to end, measured"})
      columns.push_back({title, true});
  }
  columns.push_back({"Remarks"});
  return columns;
}

}  // namespace

std::string chain_table(const Documents& documents, const timing::Model& model) {
  const auto ranks = ranks_of(model);
  const Measurements measurements(documents);
  const Place chains = documents.of_timing()["chains"];
  std::string rows;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Place chain = chains[i];
    const std::string from = chain["from"].text(), to = chain["to"].text();
    const Path path = path_of(model, ranks.at(from), ranks.at(to));
    rows += fmt::format("<tr data-up=\"{}\" data-down=\"{}\">", places(path.up), places(path.down));
    rows += row_title(from + " → " + to);
    for (const char* part : {"acquire_ns", "decide_ns", "wire_ns", "end_to_end_ns"})
      rows += chain[part].cell(Unit::time);
    rows += documents.of_simulation()["chains"][i]["max_ns"].cell(Unit::time);
    if (documents.has_run()) {
      const Place measured = measurements.chain(from, to);
      for (const char* part : {"acquire", "decide", "wire", "end_to_end"})
        rows += measured[part]["max_ns"].cell(Unit::time);
    }
    rows += word(remarks(chain)) + "</tr>\n";
  }
  return table_of("chains-table", "Age of every command: bounds, and the worst that was seen",
                  columns_of(documents.has_run()), rows);
}

}  // namespace finemote::gen::report
