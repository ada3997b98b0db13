#include "generator/report/over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "generator/report/plot.hpp"
#include "generator/report/table.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

constexpr std::size_t kMostValues = 24, kMostChains = 6;  // that are drawn

std::string name_of(const Place& series) { return series["part"].text() + " " + series["value"].text(); }

std::string unit_of(const Place& series) {
  const std::string unit = series["unit"].text();
  return unit == "us" ? "µs" : unit;
}

std::string title_of(const Place& series) {
  const std::string unit = unit_of(series);
  return name_of(series) + (unit.empty() ? "" : ", " + unit);
}

/// What the scenario wants of a quantity.
std::vector<Plot::Band> bands_of(const Documents& documents, const Place& series) {
  std::vector<Plot::Band> bands;
  const Place wanted = documents.of_run()["expectations"];
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (name_of(wanted[i]) != name_of(series)) continue;
    bands.push_back({wanted[i]["from_ns"].number(), wanted[i]["to_ns"].number(), wanted[i]["min"].number(),
                     wanted[i]["max"].number()});
  }
  return bands;
}

Plot plot_of(const Documents& documents, const Place& series) {
  Plot plot{title_of(series), series["values"].attributes()};
  const double from = series["from_ns"].number(), every = series["every_ns"].number();
  const Place values = series["values"];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].is_number()) plot.points.push_back({from + static_cast<double>(i) * every, values[i].number()});
  }
  plot.bands = bands_of(documents, series);
  return plot;
}

/// Names of devices, whose parts come after the bodies they move.
std::set<std::string> device_names(const Documents& documents) {
  std::set<std::string> names;
  const Place devices = documents.of_timing()["model"]["devices"];
  for (std::size_t i = 0; i < devices.size(); ++i) names.insert(devices[i]["name"].text());
  return names;
}

/// Numbers that count something, or are bits: their way says little.
bool is_count(const Place& series, const Plot& plot) {
  return series["unit"].text().empty() && std::all_of(plot.points.begin(), plot.points.end(),
                                                      [](const auto& point) { return point.y == std::floor(point.y); });
}

/// Those that move, the most telling first: what a scenario wants something of, then bodies, then devices.
std::vector<Plot> value_plots(const Documents& documents) {
  const std::set<std::string> devices = device_names(documents);
  std::vector<std::vector<Plot>> by_rank(3);
  const Place all = documents.of_run()["values"];
  for (std::size_t i = 0; i < all.size(); ++i) {
    Plot plot = plot_of(documents, all[i]);
    if (plot.is_constant() || (plot.bands.empty() && is_count(all[i], plot))) continue;
    const std::size_t rank = !plot.bands.empty() ? 0 : devices.count(all[i]["part"].text()) == 0 ? 1 : 2;
    by_rank[rank].push_back(std::move(plot));
  }
  std::vector<Plot> plots;
  for (std::vector<Plot>& some : by_rank) std::move(some.begin(), some.end(), std::back_inserter(plots));
  return plots;
}

Plot age_plot(const Place& chain) {
  const bool is_whole = chain["end_to_end"]["max_ns"].is_number();
  const Place figure = chain[is_whole ? "end_to_end" : "decide"];
  const Place times = chain["ages"]["t_ns"], ages = chain["ages"]["age_ns"];
  Plot plot{chain["from"].text() + " → " + chain["to"].text() + (is_whole ? ", age" : ", decide"), ages.attributes()};
  plot.is_time = true;
  for (std::size_t i = 0; i < std::min(times.size(), ages.size()); ++i) {
    if (times[i].is_number() && ages[i].is_number()) plot.points.push_back({times[i].number(), ages[i].number()});
  }
  plot.limit = figure["bound_ns"].number();
  plot.limit_attributes = figure["bound_ns"].attributes();
  return plot;
}

/// Of the chains whose commands were oldest.
std::vector<Plot> age_plots(const Documents& documents) {
  std::vector<Plot> plots;
  const Place chains = documents.of_run()["chains"];
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Plot plot = age_plot(chains[i]);
    if (plot.points.size() > 1) plots.push_back(std::move(plot));
  }
  const auto oldest = [](const Plot& plot) {
    double most = 0;
    for (const Plot::Point& point : plot.points) most = std::max(most, point.y);
    return most;
  };
  std::stable_sort(plots.begin(), plots.end(), [&](const Plot& a, const Plot& b) { return oldest(a) > oldest(b); });
  return plots;
}

std::string figures_of(const std::vector<Plot>& plots, std::size_t most) {
  std::string text = "<div class=\"plots\">\n";
  for (std::size_t i = 0; i < std::min(plots.size(), most); ++i)
    text += "<figure><figcaption>" + svg::escaped(plots[i].title) + "</figcaption>\n" + drawn(plots[i]) + "</figure>\n";
  return text + "</div>\n";
}

std::string value_table(const Place& all) {
  std::string rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    rows += "<tr>" + row_title(all[i]["part"].text()) + word(all[i]["value"].text()) + word(unit_of(all[i]));
    for (const char* member : {"lowest", "highest", "last"}) rows += all[i][member].cell(Unit::number);
    rows += "</tr>\n";
  }
  return table_of("values-table", "Every quantity of every part",
                  {{"Part"}, {"Quantity"}, {"Unit"}, {"Lowest", true}, {"Highest", true}, {"Last", true}}, rows);
}

std::string expectation_table(const Place& all) {
  if (all.size() == 0) return {};
  std::string rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool ok = all[i]["ok"].is_true();
    rows += fmt::format("<tr class=\"{}\">", ok ? "good" : "bad") + row_title(name_of(all[i])) +
            fmt::format("<td class=\"state\">{}</td>", ok ? "✓ met" : "✗ not met") +
            all[i]["from_ns"].cell(Unit::time) + all[i]["to_ns"].cell(Unit::time);
    for (const char* member : {"min", "max", "lowest", "highest"}) rows += all[i][member].cell(Unit::number);
    rows += "</tr>\n";
  }
  return table_of("expectations-table", "What the scenario wants, and what was",
                  {{"Quantity"},
                   {"State"},
                   {"From", true},
                   {"To", true},
                   {"At least", true},
                   {"At most", true},
                   {"Lowest", true},
                   {"Highest", true}},
                  rows);
}

std::string values_text(const Documents& documents) {
  const Place all = documents.of_run()["values"];
  if (all.size() == 0) return {};
  const std::vector<Plot> plots = value_plots(documents);
  std::string text = "<h3>The robot and its parts</h3>\n";
  if (std::any_of(plots.begin(), plots.end(), [](const Plot& plot) { return !plot.bands.empty(); }))
    text += "<p>The dashed boxes are where the scenario wants a value to be.</p>\n";
  text += figures_of(plots, kMostValues);
  const std::size_t rest = all.size() - std::min(plots.size(), kMostValues);
  if (rest > 0)
    text += fmt::format(
        "<p class=\"note\">{} more are only in the table below: counters, what did not change, and what is one too "
        "many.</p>\n",
        rest);
  text += expectation_table(documents.of_run()["expectations"]);
  return text + "<details><summary>The quantities as a table</summary>\n" + value_table(all) + "</details>\n";
}

std::string ages_text(const Documents& documents) {
  const std::vector<Plot> plots = age_plots(documents);
  if (plots.empty()) return {};
  std::string text =
      "<h3>How old commands were</h3>\n<p>Each point is a command at the time when it took effect; where many follow "
      "closely, the oldest of them. The worst of each chain is in the table of chains.</p>\n" +
      figures_of(plots, kMostChains);
  if (plots.size() > kMostChains)
    text += fmt::format("<p class=\"note\">Of {} chains, the {} with the oldest commands are drawn.</p>\n",
                        plots.size(), kMostChains);
  return text;
}

}  // namespace

std::string over_time(const Documents& documents) { return values_text(documents) + ages_text(documents); }

}  // namespace finemote::gen::report
