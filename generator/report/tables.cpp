#include "generator/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/report/table.hpp"
#include "generator/svg/svg.hpp"

namespace finemote::gen::report {
namespace {

std::vector<Column> device_columns(bool has_run) {
  std::vector<Column> columns{{"Device"},         {"Type"},           {"Period"},    {"Bus"},
                              {"update()", true}, {"handle()", true}, {"Times are"}, {"Response, bound", true},
                              {"simulated", true}};
  if (has_run) {
    columns.push_back({"measured", true});
    columns.push_back({"update(), measured", true});
    columns.push_back({"handle(), measured", true});
  }
  return columns;
}

std::string device_row(const Documents& documents, const Measurements& measurements, const ForestRow& row) {
  const std::size_t rank = row.rank.value();
  const Place model = documents.of_timing()["model"]["devices"][rank];
  const Place label = documents.of_timing()["wcet_labels"][rank]["label"];
  std::string text = fmt::format("<tr data-device=\"{}\">", rank) + row_title(row.name) + word(row.type) +
                     word(row.period) + word(row.place) + model["update_wcet_ns"].cell(Unit::time) +
                     model["handle_wcet_ns"].cell(Unit::time) + word(label.text()) +
                     documents.of_verdict()["devices"][rank]["r_minus_ns"].cell(Unit::time) +
                     documents.of_simulation()["devices"][rank]["response_max_ns"].cell(Unit::time);
  if (documents.has_run()) {
    text += measurements.response(row.name)["handle_max_ns"].cell(Unit::time);
    text += measurements.stage(row.name, "update")["own_max_ns"].cell(Unit::time);
    text += measurements.stage(row.name, "handle")["own_max_ns"].cell(Unit::time);
  }
  return text + "</tr>\n";
}

/// Whose a part of the image is, for people.
std::string owner_of(const Place& part) {
  const std::string kind = part["kind"].text(), name = part["name"].text();
  if (kind == "type") return "code of type " + name;
  if (kind == "generated") return "stages, ports and constants of the robot";
  if (kind == "rest") return "runtime, board and libraries";
  return kind + " " + name;
}

/// What a use of the processor is, for people.
std::string user_of(const Place& use) {
  const std::string kind = use["kind"].text(), name = use["name"].text(), source = use["source"].text();
  if (kind == "bucket") return "devices every " + name;
  if (kind == "flush") return "output of " + name + (source.empty() ? "" : ", every " + source);
  if (kind == "interrupt") return "interrupts of " + name + (source.empty() ? "" : ", " + source);
  return "releases, which start jobs";
}

/// What the time of a use is: static, assumed and so on; empty where it is that of several devices.
std::string label_of(const Documents& documents, const Place& use) {
  const bool is_release = use["kind"].text() == "release";
  const std::string what = is_release ? "release and jobs" : use["name"].text() + "." + use["source"].text();
  const Place labels = documents.of_timing()["cost_labels"];
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i]["what"].text() == what) return labels[i]["label"].text();
  }
  return {};
}

/// The largest of a member, which bars are drawn beside; never 0.
double most_of(const Place& list, const char* member) {
  double most = 0;
  for (std::size_t i = 0; i < list.size(); ++i) most = std::max(most, list[i][member].number());
  return most > 0 ? most : 1;
}

}  // namespace

std::string requirement_table(const Documents& documents) {
  const Place requirements = documents.of_timing()["requirements"];
  if (requirements.size() == 0) return "<p>The robot states no requirement.</p>\n";
  std::string rows;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Place r = requirements[i];
    const std::string kind = r["kind"].text();
    const Unit unit = kind == "utilization" ? Unit::share : Unit::time;
    const bool ok = r["ok"].is_true();
    rows += fmt::format("<tr class=\"{}\">", ok ? "good" : "bad") + row_title(r["text"].text()) +
            fmt::format("<td class=\"state\">{}</td>", ok ? "✓ met" : "✗ not met") + r["max"].cell(unit) +
            r["value"].cell(unit) + r["slack"].cell(unit == Unit::time ? Unit::room : unit) +
            word(kind + (r["of"].text() == "decision" ? " of the decision" : "")) + word(r["where"].text()) + "</tr>\n";
  }
  return table_of("requirements-table", "What the robot's file asks for",
                  {{"Requirement"}, {"State"}, {"Limit", true}, {"Bound", true}, {"Slack", true}, {"Of"}, {"Where"}},
                  rows);
}

std::string device_table(const Documents& documents, const ForestView& view) {
  const Measurements measurements(documents);
  std::string rows;
  for (const ForestRow& row : view.rows) rows += device_row(documents, measurements, row);
  return table_of("devices-table", "Every device: own times and responses", device_columns(documents.has_run()), rows);
}

std::string processor_table(const Documents& documents) {
  const Place uses = documents.of_timing()["processor"];
  const double most = most_of(uses, "utilization");
  std::string rows;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const Place use = uses[i];
    rows += "<tr>" + row_title(user_of(use)) + use["cost_ns"].cell(Unit::time) + use["every_ns"].cell(Unit::time) +
            use["utilization"].cell(Unit::share) + share_bar(use["utilization"].number() / most) +
            word(label_of(documents, use)) + "</tr>\n";
  }
  return table_of("processor-table", "Who uses the processor, at most; bars compare shares",
                  {{"User"}, {"Each", true}, {"Closest together", true}, {"Share", true}, {""}, {"Times are"}}, rows);
}

std::string image_table(const Documents& documents) {
  const Place parts = documents.of_run()["image"]["parts"];
  const double most_flash = most_of(parts, "flash"), most_ram = most_of(parts, "ram");
  std::string rows;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Place part = parts[i];
    if (part["flash"].number() == 0 && part["ram"].number() == 0) continue;
    rows += "<tr>" + row_title(owner_of(part)) + part["flash"].cell(Unit::bytes) +
            share_bar(part["flash"].number() / most_flash) + part["ram"].cell(Unit::bytes) +
            share_bar(part["ram"].number() / most_ram) + "</tr>\n";
  }
  if (rows.empty()) return {};
  return table_of("image-table", "Whose flash and RAM it is, as far as the image's symbols say",
                  {{"Owner"}, {"Flash", true}, {""}, {"RAM", true}, {""}}, rows);
}

std::string bus_table(const Documents& documents) {
  const Place loads = documents.of_timing()["bus_load"];
  if (loads.size() == 0) return "<p>The robot has no bus.</p>\n";
  std::string rows;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    rows += "<tr>" + row_title(loads[i]["name"].text()) + loads[i]["wire_ns_per_s"].cell(Unit::time) +
            loads[i]["utilization"].cell(Unit::share) + share_bar(loads[i]["utilization"].number()) + "</tr>\n";
  }
  return table_of("buses-table", "How much of each bus is taken",
                  {{"Bus"}, {"On the wire, per second", true}, {"Share", true}, {""}}, rows);
}

std::string assumption_table(const Documents& documents) {
  const Place list = documents.of_timing()["assumptions"];
  std::string rows;
  for (std::size_t i = 0; i < list.size(); ++i) {
    rows += "<tr>" + row_title(list[i]["id"].text()) + word(list[i]["text"].text()) + word(list[i]["detected"].text()) +
            "</tr>\n";
  }
  return table_of("assumptions-table", "What every bound assumes", {{"Name"}, {"Assumption"}, {"When violated"}}, rows);
}

}  // namespace finemote::gen::report
