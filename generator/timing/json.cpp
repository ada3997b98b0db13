#include "generator/timing/json.hpp"

#include <algorithm>

#include "generator/timing/assumptions.hpp"
#include "generator/timing/cost_labels.hpp"
#include "generator/timing/model_words.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

Json number(const std::optional<Duration>& value) { return value ? Json(value->ns()) : Json(nullptr); }

Json name_of(const Model& model, std::optional<Rank> device) {
  return device ? Json(model.devices[*device].name) : Json(nullptr);
}

std::string_view class_name(TreeResult::Class kind) {
  switch (kind) {
    case TreeResult::Class::same_period:
      return "same-period";
    case TreeResult::Class::harmonic:
      return "harmonic";
    case TreeResult::Class::general:
      return "general";
  }
  return "";
}

void add_if(Json& out, const char* key, std::int64_t value) {
  if (value != 0) out[key] = value;
}
void add_if(Json& out, const char* key, Duration value) { add_if(out, key, value.ns()); }

Json source_json(const Model& model, const InterruptSource& source) {
  Json out{{"name", source.name}, {"wcet_ns", source.wcet.ns()}, {"min_interval_ns", source.min_interval.ns()}};
  for (const FrameBudget& b : source.budgets) {
    Json budget{{"device", model.devices[b.device].name}, {"count", b.count}};
    if (b.every != 1) budget["every"] = b.every;
    add_if(budget, "interval_ns", b.interval);
    if (b.carry_in != 1) budget["carry_in"] = b.carry_in;
    if (b.cause != InterruptCause::clock) budget["cause"] = word_of(b.cause, kCauseWords);
    if (b.asked_in != AskedIn::handle) budget["asked_in"] = word_of(b.asked_in, kAskedInWords);
    out["budgets"].push_back(std::move(budget));
  }
  if (source.of_transfers) out["of_transfers"] = true;
  if (source.ends_frame) out["ends_frame"] = true;
  if (source.steals) out["steals"] = true;
  return out;
}

Json bus_json(const Model& model, const Bus& bus) {
  Json out{{"name", bus.name},
           {"baud_bps", bus.baud_bps},
           {"min_frame_bits", bus.min_frame_bits},
           {"wcet_ns", bus.wcet.ns()}};
  if (bus.arbitrated) out["arbitrated"] = true;
  if (bus.polled) out["polled"] = true;
  if (bus.is_pins) out["pins"] = true;
  if (bus.sources) {
    Json& list = out["sources"] = Json::array();
    for (const InterruptSource& s : *bus.sources) list.push_back(source_json(model, s));
  }
  return out;
}

Json transfer_json(const Model& model, const Transfer& t) {
  Json out{{"bus", model.buses[t.bus].name}, {"wire_ns", t.wire.ns()}, {"after", word_of(t.after, kAfterWords)}};
  add_if(out, "min_interval_ns", t.min_interval);
  if (t.interrupts != 1) out["interrupts"] = t.interrupts;
  if (t.frames != 1) out["frames"] = t.frames;
  add_if(out, "service_ns", t.service);
  if (t.identifier) out["identifier"] = *t.identifier;
  if (t.command) out["command"] = true;
  if (t.slot != 0) out["slot"] = t.slot;
  if (t.turns != 1 && t.slot != 0) out["turns"] = t.turns;
  if (t.reads) out["reads"] = true;
  if (t.receive) out["receive"] = true;
  return out;
}

Json device_json(const Model& model, const Device& d) {
  Json out{{"name", d.name},
           {"parent", name_of(model, d.parent)},
           {"period_ns", d.period.ns()},
           {"update_wcet_ns", d.update_wcet.ns()},
           {"handle_wcet_ns", d.handle_wcet.ns()}};
  add_if(out, "update_bcet_ns", d.update_bcet);
  add_if(out, "handle_bcet_ns", d.handle_bcet);
  add_if(out, "update_extra_ns", d.update_extra);
  add_if(out, "handle_extra_ns", d.handle_extra);
  add_if(out, "output_ns", d.output);
  if (d.sets_late) out["sets_late"] = true;
  if (!d.takes_command) out["takes_command"] = false;
  if (d.unknown_age != UnknownAge::none) out["unknown_age"] = word_of(d.unknown_age, kUnknownAgeWords);
  for (const Rank r : d.reads) out["reads"].push_back(model.devices[r].name);
  if (d.acquisition) {
    Json& a = out["acquisition"] = Json{{"fixed_ns", d.acquisition->fixed.ns()}};
    add_if(a, "interval_ns", d.acquisition->interval);
    add_if(a, "periods", d.acquisition->periods);
    if (d.acquisition->begun_every != 1) a["begun_every"] = d.acquisition->begun_every;
    if (d.acquisition->every != 1) a["every"] = d.acquisition->every;
    add_if(a, "conversion_ns", d.acquisition->conversion);
    if (d.acquisition->conversions != 1) a["conversions"] = d.acquisition->conversions;
    if (d.acquisition->assumed) a["assumed"] = true;
  }
  for (const Transfer& t : d.transfers) out["transfers"].push_back(transfer_json(model, t));
  for (const BusPlace bus : d.undeclared) out["undeclared"].push_back(model.buses[bus].name);
  return out;
}

Json flush_json(const Model& model, const Flush& f) {
  Json out{{"period_ns", f.period.ns()}, {"wcet_ns", f.wcet.ns()}};
  if (f.bus) out["bus"] = model.buses[*f.bus].name;
  add_if(out, "wire_ns", f.wire);
  if (f.interrupts != 1) out["interrupts"] = f.interrupts;
  add_if(out, "service_ns", f.service);
  if (!f.identifiers.empty()) out["identifiers"] = f.identifiers;
  if (!f.output.empty()) out["output"] = f.output;
  for (const Rank d : f.devices) out["devices"].push_back(model.devices[d].name);
  return out;
}

Json bucket_json(const Model& model, const BucketResult& bucket) {
  Json devices = Json::array();
  for (const Rank d : bucket.devices) devices.push_back(model.devices[d].name);
  Json out{{"period_ns", bucket.period.ns()},
           {"wcet_ns", bucket.wcet.ns()},
           {"devices", std::move(devices)},
           {"response_ns", number(bucket.response)},
           {"ok", bucket.ok}};
  if (bucket.closed_form) out["closed_form"] = true;
  return out;
}

Json device_result_json(const Device& device, const DeviceResult& r, Profile profile) {
  Json out{{"name", device.name},
           {"b_plus_ns", r.b_plus.ns()},
           {"b_minus_ns", r.b_minus.ns()},
           {"r_plus_ns", number(r.r_plus)},
           {"r_minus_ns", number(r.r_minus)}};
  if (profile != Profile::paper) out["window_ns"] = number(r.window);
  if (r.closed_form) out["closed_form"] = true;
  return out;
}

Json path_json(const Model& model, const PathResult& path) {
  Json out{{"leaf", model.devices[path.leaf].name},
           {"latency_ns", number(path.latency)},
           {"release_ns", number(path.release)},
           {"source_release_ns", number(path.source_release)}};
  if (path.closed_form) out["closed_form"] = true;
  return out;
}

Json tree_json(const Model& model, const TreeResult& tree, Profile profile) {
  Json out{{"root", model.devices[tree.root].name},
           {"class", class_name(tree.kind)},
           {"latency_ns", number(tree.latency)},
           {"worst_leaf", name_of(model, tree.worst_leaf)},
           {"worst_release_ns", number(tree.worst_release)},
           {"source_release_ns", number(tree.source_release)}};
  if (profile == Profile::paper) {
    out["corollary_ns"] = number(tree.corollary);
    out["cross_latency_ns"] = number(tree.cross_latency);
  }
  if (tree.closed_form) out["closed_form"] = true;
  Json& paths = out["paths"] = Json::array();
  for (const PathResult& p : tree.paths) paths.push_back(path_json(model, p));
  return out;
}

Json chain_json(const Timing& timing, const ChainResult& c) {
  const Model& model = timing.model;
  Json out{{"from", model.devices[c.from].name},
           {"to", model.devices[c.to].name},
           {"decide_ns", number(c.decide)},
           {"acquire_ns", number(c.acquire)},
           {"stamped_ns", number(timing.stamped_ages[c.from])},
           {"wire_ns", number(c.wire)},
           {"end_to_end_ns", number(c.end_to_end)},
           {"assumed", c.assumed}};
  if (c.through_reads) out["through_reads"] = true;
  if (c.closed_form) out["closed_form"] = true;
  return out;
}

std::string_view kind_name(Requirement::Kind kind) {
  switch (kind) {
    case Requirement::Kind::latency_end_to_end:
    case Requirement::Kind::latency_decision:
      return "latency";
    case Requirement::Kind::utilization:
      return "utilization";
    case Requirement::Kind::jitter:
      return "jitter";
  }
  return "";
}

/// How far the value may still rise; below zero: by how much it is too large.
Json slack_json(const RequirementResult& r) {
  if (r.fraction) return r.requirement.max_fraction - *r.fraction;
  return r.value ? Json((r.requirement.max - *r.value).ns()) : Json(nullptr);
}

Json requirement_json(const RequirementResult& r) {
  const Requirement& wanted = r.requirement;
  const bool share = wanted.kind == Requirement::Kind::utilization;
  Json out{{"kind", kind_name(wanted.kind)}, {"text", wanted.text}};
  if (wanted.kind == Requirement::Kind::latency_decision) out["of"] = "decision";
  out["max"] = share ? Json(wanted.max_fraction) : Json(wanted.max.ns());
  out["value"] = r.fraction ? Json(*r.fraction) : number(r.value);
  out["slack"] = slack_json(r);
  out["ok"] = r.ok;
  out["where"] =
      wanted.at.file != nullptr ? Json(wanted.at.file->name + ":" + std::to_string(wanted.at.line)) : Json(nullptr);
  return out;
}

/// Of an interrupt, which of its bus; of a flush, the period of its bucket.
Json source_json(const ProcessorUse& use) {
  if (use.kind == ProcessorUse::Kind::flush) return units::format_duration(use.every);
  return use.source.empty() ? Json(nullptr) : Json(use.source);
}

Json processor_json(const Timing& timing) {
  Json list = Json::array();
  for (const ProcessorUse& use : timing.processor) {
    list.push_back(Json{{"kind", kind_name(use.kind)},
                        {"name", use.name},
                        {"source", source_json(use)},
                        {"cost_ns", use.cost.ns()},
                        {"every_ns", use.every.ns()},
                        {"utilization", use.utilization},
                        {"share", use.utilization / timing.processor_load}});
  }
  return list;
}

/// What each execution time rests on, in the words of documents; null: the model does not say.
Json labels_json(const Model& model) {
  Json list = Json::array();
  for (const Device& d : model.devices) {
    const bool is_known = d.source != WcetSource::unknown;
    Json entry{{"device", d.name}, {"label", is_known ? Json(label_of(d.source)) : Json(nullptr)}};
    if (d.update_static) entry["update_static_ns"] = d.update_static->ns();
    if (d.handle_static) entry["handle_static_ns"] = d.handle_static->ns();
    list.push_back(std::move(entry));
  }
  return list;
}

/// The same of what runs beside stages: interrupt routines by `bus.source`, and the rest of the scheduler's work.
Json cost_labels_json(const Model& model) {
  Json list = Json::array();
  for (const CostLabel& cost : cost_labels(model)) {
    const bool is_known = cost.source != WcetSource::unknown;
    list.push_back(Json{{"what", cost.what}, {"label", is_known ? Json(label_of(cost.source)) : Json(nullptr)}});
  }
  return list;
}

Json assumptions_json() {
  Json list = Json::array();
  for (const Assumption& a : assumptions())
    list.push_back(Json{{"id", a.id}, {"text", a.text}, {"detected", to_string(a.detected)}});
  return list;
}

/// All of a robot's; of another model those that it gives.
Json costs_json(const Costs& costs) {
  Json out = Json::object();
  const auto add = [&](const char* key, Duration cost) {
    if (costs.source != WcetSource::unknown || cost != Duration::zero()) out[key] = cost.ns();
  };
  add("release_ns", costs.release);
  add("release_per_bucket_ns", costs.release_per_bucket);
  add("interrupt_ns", costs.interrupt);
  add("job_ns", costs.job);
  add("stage_ns", costs.stage);
  add("masked_ns", costs.masked);
  if (costs.keeps_one_release) out["keeps_one_release"] = true;
  if (costs.longest_release > Duration::zero()) out["longest_release_ns"] = costs.longest_release.ns();
  if (costs.event_entry > Duration::zero()) out["event_entry_ns"] = costs.event_entry.ns();
  if (costs.event_pause > Duration::zero()) out["event_pause_ns"] = costs.event_pause.ns();
  return out;
}

}  // namespace

Json model_json(const Model& model) {
  Json out{{"tick_ns", model.tick.ns()}, {"buses", Json::array()}, {"devices", Json::array()}};
  for (const Bus& bus : model.buses) out["buses"].push_back(bus_json(model, bus));
  for (const Device& d : model.devices) out["devices"].push_back(device_json(model, d));
  add_if(out, "clock_ppm", model.clock_ppm);
  Json costs = costs_json(model.costs);
  if (!costs.empty()) out["costs"] = std::move(costs);
  for (const Flush& f : model.flushes) {
    out["flushes"].push_back(flush_json(model, f));
  }
  return out;
}

void add_utilization(const Model& model, const UtilizationTests& tests, Json& out) {
  out["utilization"] = {
      {"exact", tests.utilization.exact}, {"value", tests.utilization.value}, {"overload", tests.utilization.overload}};
  out["liu_layland"] = {{"n", tests.liu_layland.n}, {"bound", tests.liu_layland.bound}, {"ok", tests.liu_layland.ok}};
  out["hyperbolic_ok"] = tests.hyperbolic_ok;
  Json& buses = out["buses"] = Json::array();
  for (const Bus& bus : model.buses) {
    buses.push_back(Json{{"name", bus.name},
                         {"frame_ns", bus.frame.ns()},
                         {"period_ns", std::min(bus.frame, model.tick).ns()},
                         {"wcet_ns", bus.wcet.ns()}});
  }
}

Json profile_json(const Model& model, const ProfileResult& result) {
  Json out{{"schedulable", result.schedulable}};
  if (result.release) {
    out["release"] =
        Json{{"response_ns", number(result.release->response)}, {"deadline_ns", result.release->deadline.ns()}};
  }
  Json& buckets = out["buckets"] = Json::array();
  for (const BucketResult& b : result.buckets) buckets.push_back(bucket_json(model, b));
  Json& devices = out["devices"] = Json::array();
  for (const Rank d : result.devices.ids()) {
    devices.push_back(device_result_json(model.devices[d], result.devices[d], result.profile));
  }
  Json& trees = out["trees"] = Json::array();
  for (const TreeResult& t : result.trees) trees.push_back(tree_json(model, t, result.profile));
  return out;
}

Json timing_json(const Timing& timing) {
  const Model& model = timing.model;
  Json out{{"schema", "finemote.timing/1"}, {"model", model_json(model)}, {"profile", profile_name(timing.asked)}};
  add_utilization(model, timing.utilization, out);
  out["paper"] = profile_json(model, timing.paper);
  out["tight"] = profile_json(model, timing.tight);
  out["target"] = timing.target ? profile_json(model, *timing.target) : Json(nullptr);
  out["schedulable"] = timing.schedulable;
  out["processor_load"] = timing.processor_load;
  out["processor"] = processor_json(timing);
  Json& chains = out["chains"] = Json::array();
  for (const ChainResult& c : timing.chains) chains.push_back(chain_json(timing, c));
  for (const MissingBound& missing : timing.missing) {
    const Json why{{"part", part_name(missing.part)}, {"why", missing.why}, {"restored_by", missing.restored_by}};
    for (const std::size_t c : missing.chains) chains[c]["unbounded"].push_back(why);
  }
  Json& requirements = out["requirements"] = Json::array();
  for (const RequirementResult& r : timing.requirements) requirements.push_back(requirement_json(r));
  Json& loads = out["bus_load"] = Json::array();
  for (const BusPlace b : timing.bus_loads.ids()) {
    loads.push_back(Json{{"name", model.buses[b].name},
                         {"wire_ns_per_s", timing.bus_loads[b].wire_per_s.ns()},
                         {"utilization", timing.bus_loads[b].utilization}});
  }
  Json& assumed = out["assumed_wcet"] = Json::array();
  for (const Rank d : timing.assumed) assumed.push_back(model.devices[d].name);
  out["wcet_labels"] = labels_json(model);
  out["cost_labels"] = cost_labels_json(model);
  out["assumptions"] = assumptions_json();
  return out;
}

}  // namespace finemote::gen::timing
