#include "generator/timing/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "generator/diagnostic/render.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing/table.hpp"

namespace finemote::gen::timing {
namespace {

constexpr std::size_t kMostDevicesForSlack = 500;  ///< every device is bisected on its own

struct Slack {
  Ns all = 0;
  std::vector<Ns> one;  ///< per device; empty for large models
};

Slack find_slack(const Model& model, Profile profile) {
  Slack slack{slack_permille(model, profile), {}};
  if (model.devices.size() > kMostDevicesForSlack) return slack;
  for (std::size_t d = 0; d < model.devices.size(); ++d) slack.one.push_back(slack_permille(model, profile, d));
  return slack;
}

Json factor_json(Ns permille) {
  return permille >= kMostSlack ? Json(nullptr) : Json(static_cast<double>(permille) / 1000);
}

Json slack_json(const Model& model, const Slack& slack) {
  Json out{{"factor", factor_json(slack.all)}, {"devices", Json::array()}};
  for (std::size_t d = 0; d < slack.one.size(); ++d) {
    out["devices"].push_back(Json{{"name", model.devices[d].name}, {"factor", factor_json(slack.one[d])}});
  }
  return out;
}

std::string factor_text(Ns permille) {
  if (permille >= kMostSlack) return "over 1000";
  return fmt::format("{}.{:03}", permille / 1000, permille % 1000);
}

std::string slack_text(const Model& model, const Slack& slack) {
  std::string text = fmt::format(
      "\nslack (factor on execution times up to which every bucket ends in its period)\n  all together  {}\n",
      factor_text(slack.all));
  if (slack.one.empty()) return text;
  Table table({"device alone", "factor"});
  for (std::size_t d = 0; d < slack.one.size(); ++d) table.row({model.devices[d].name, factor_text(slack.one[d])});
  return text + table.text();
}

/// What the chains become, where it is another bound.
std::string changed_chains(const Timing& timing, const std::vector<std::size_t>& order, const Model& better) {
  AnalysisRequest request;
  request.profile = timing.asked;
  const auto place = [&](std::size_t d) {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), d) - order.begin());
  };
  for (const ChainResult& chain : timing.chains) request.chains.push_back({place(chain.from), place(chain.to)});
  Diagnostics same_as_before;
  const auto then = analyse(better, request, same_as_before);
  if (!then) return {};
  const auto shown = [](const ChainResult& chain) {
    return chain.end_to_end_ns ? chain.end_to_end_ns : chain.decide_ns;
  };
  Table table({"chain", "end to end", "then"});
  for (std::size_t c = 0; c < timing.chains.size(); ++c) {
    const ChainResult& chain = timing.chains[c];
    const auto found = std::find_if(then->chains.begin(), then->chains.end(), [&](const ChainResult& other) {
      return other.from == request.chains[c].from && other.to == request.chains[c].to;
    });
    if (found == then->chains.end() || shown(*found) == shown(chain)) continue;
    table.row({timing.model.devices[chain.from].name + " -> " + timing.model.devices[chain.to].name,
               duration_text(shown(chain)), duration_text(shown(*found))});
  }
  return table.text();
}

std::string order_text(const Model& model, const std::vector<std::size_t>& order, const Timing& timing,
                       Profile profile) {
  if (std::is_sorted(order.begin(), order.end())) return "\nno better order of siblings and roots was found\n";
  const Model better = reorder(model, order);
  const ProfileResult result = analyse_profile(better, make_topology(better), profile).result;
  std::string text = "\nsuggested order of registration\n ";
  for (const std::size_t d : order) text += " " + model.devices[d].name;
  text += "\n";
  Table table({"tree", "latency", "then"});
  for (const TreeResult& tree : timing.verdict().trees) {
    const auto then = std::find_if(result.trees.begin(), result.trees.end(), [&](const TreeResult& t) {
      return better.devices[t.root].name == model.devices[tree.root].name;
    });
    table.row({model.devices[tree.root].name, duration_text(tree.latency_ns), duration_text(then->latency_ns)});
  }
  return text + table.text() + changed_chains(timing, order, better);
}

void assume(Model& model, Ns wcet) {
  for (Device& d : model.devices) {
    if (d.source == WcetSource::assumed) d.update_wcet_ns = d.handle_wcet_ns = wcet;
  }
}

}  // namespace

std::optional<Profile> profile_of(std::string_view name) {
  for (const Profile p : {Profile::paper, Profile::tight, Profile::target}) {
    if (profile_name(p) == name) return p;
  }
  return std::nullopt;
}

int run_analyze(Model model, const std::vector<Requirement>& requirements, const AnalyzeOptions& options,
                Diagnostics& diagnostics, std::ostream& out) {
  if (options.assume_wcet_ns) assume(model, *options.assume_wcet_ns);
  AnalysisRequest request;
  request.profile = options.profile;
  request.requirements = requirements;
  request.chains = parse_chains(model, options.chains, diagnostics);
  if (diagnostics.has_errors()) return 2;
  request.remodel = options.remodel ? options.remodel : model_remodel(model);
  const std::optional<Timing> timing = analyse(model, request, diagnostics);
  if (!timing) return 2;
  std::optional<Slack> slack;
  if (options.slack) slack = find_slack(model, timing->asked);
  std::vector<std::size_t> order;
  if (options.suggest_order) order = suggest_order(model, timing->asked);
  if (options.json) {
    Json document = timing_json(*timing);
    if (slack) document["slack"] = slack_json(model, *slack);
    for (const std::size_t d : order) document["suggested_order"].push_back(model.devices[d].name);
    document["diagnostics"] = render_json(diagnostics);
    out << document.dump(2) << '\n';
  } else {
    out << timing_table(*timing);
    if (slack) out << slack_text(model, *slack);
    if (options.suggest_order) out << order_text(model, order, *timing, timing->asked);
  }
  return timing->schedulable && timing->requirements_hold() ? 0 : 1;
}

}  // namespace finemote::gen::timing
