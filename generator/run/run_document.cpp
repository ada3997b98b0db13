#include "generator/run/run_document.hpp"

#include "generator/forest/stage.hpp"
#include "generator/run/run_series.hpp"
#include "generator/run/violation.hpp"
#include "generator/tasks/from_robot.hpp"
#include "generator/timing/words.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Null of what nothing was seen.
template <class Value>
Json seen(const Statistics& s, Value value) {
  return s.count > 0 ? Json(value) : Json(nullptr);
}

Json bound(std::optional<Duration> time) { return time ? Json(time->ns()) : Json(nullptr); }

Json statistics(const Measured& figure) {
  const Statistics& s = figure.observed;
  return {{"min_ns", seen(s, s.min.ns())},   {"mean_ns", seen(s, s.mean_ns)},
          {"sd_ns", seen(s, s.sd_ns)},       {"max_ns", seen(s, s.max.ns())},
          {"bound_ns", bound(figure.bound)}, {"judged", judgement_name(figure.judged())}};
}

/// Says of what is broken which violated assumption it rests on.
/// @param was_broken  before that
Json excused(Json document, const RunResult& result, const Journey& journey, Judgement judged, bool was_broken) {
  const auto assumption = violated_assumption(result.robot, result.record.violated, journey);
  if (assumption && judged == Judgement::broken && !was_broken) document["assumption"] = *assumption;
  return document;
}

Json statistics(const RunResult& result, const MeasuredChain& chain, Measured MeasuredChain::*figure) {
  const Measured& measured = chain.*figure;
  return excused(statistics(measured), result, journey_of(chain, figure), measured.judged(), measured.was_broken);
}

Json own_time(const RunResult& result, DeviceId device, bool is_handle) {
  for (const OwnTime& own : result.record.own_times) {
    if (own.device == device && own.is_handle == is_handle) return own.longest.ns();
  }
  return nullptr;
}

Json stage_list(const RunResult& result) {
  Json list = Json::array();
  for (DeviceId device : result.forest.order) {
    for (const bool is_handle : {false, true}) {
      const Statistics& s = result.figures.stages[device][is_handle ? 1 : 0];
      const Wcet& wcet = result.wcets_given[device];
      Json stage{{"device", name_of(result, device)},
                 {"stage", stage_name(is_handle)},
                 {"count", s.count},
                 {"min_ns", seen(s, s.min.ns())},
                 {"mean_ns", seen(s, s.mean_ns)},
                 {"max_ns", seen(s, s.max.ns())},
                 {"own_max_ns", own_time(result, device, is_handle)},
                 {"wcet_ns", (is_handle ? wcet.handle : wcet.update).ns()},
                 {"wcet_label", timing::label_of(timing::source_of(wcet.source))}};
      const auto& computed = is_handle ? wcet.handle_static : wcet.update_static;
      if (computed) stage["static_ns"] = computed->ns();
      list.push_back(std::move(stage));
    }
  }
  return list;
}

Json event_list(const RunResult& result) {
  Json list = Json::array();
  for (const Event& event : result.record.events) {
    if (event.at >= result.shown) break;
    list.push_back({{"t_ns", event.at.ns()},
                    {"device", name_of(result, event.device)},
                    {"stage", stage_name(event.is_handle)},
                    {"edge", event.is_end ? "end" : "begin"}});
  }
  return list;
}

Json chain_list(const RunResult& result) {
  Json list = Json::array();
  const std::size_t most = most_ages(result.figures.chains.size());
  for (const MeasuredChain& chain : result.figures.chains) {
    list.push_back({{"from", name_of(result, chain.from)},
                    {"to", name_of(result, chain.to)},
                    {"samples", chain.decide.observed.count},
                    {"decide", statistics(result, chain, &MeasuredChain::decide)},
                    {"acquire", statistics(result, chain, &MeasuredChain::acquire)},
                    {"wire", statistics(result, chain, &MeasuredChain::wire)},
                    {"end_to_end", statistics(result, chain, &MeasuredChain::end_to_end)},
                    {"ages", ages_of(chain, most)}});
  }
  return list;
}

Json largest(const Measured& figure) { return seen(figure.observed, figure.observed.max.ns()); }

/// The worst of two judgements of one device: what is broken, then what nobody could judge.
Judgement both(Judgement a, Judgement b) {
  for (const Judgement j : {Judgement::broken, Judgement::no_bound, Judgement::no_sample}) {
    if (a == j || b == j) return j;
  }
  return Judgement::held;
}

Json response_list(const RunResult& result) {
  Json list = Json::array();
  for (const MeasuredResponse& response : result.figures.responses) {
    const Judgement judged = both(response.update.judged(), response.handle.judged());
    list.push_back(excused({{"device", name_of(result, response.device)},
                            {"update_max_ns", largest(response.update)},
                            {"update_bound_ns", bound(response.update.bound)},
                            {"handle_max_ns", largest(response.handle)},
                            {"handle_bound_ns", bound(response.handle.bound)},
                            {"judged", judgement_name(judged)}},
                           result, {}, judged, response.update.was_broken || response.handle.was_broken));
  }
  return list;
}

Json jitter_list(const RunResult& result) {
  Json list = Json::array();
  for (const MeasuredResponse& response : result.figures.responses) {
    const Judgement judged = response.jitter.judged();
    list.push_back(excused({{"device", name_of(result, response.device)},
                            {"max_ns", largest(response.jitter)},
                            {"bound_ns", bound(response.jitter.bound)},
                            {"judged", judgement_name(judged)}},
                           result, {}, judged, response.jitter.was_broken));
  }
  return list;
}

Json claim_list(const RunResult& result) {
  Json list = Json::array();
  for (const MeasuredClaim& claim : result.figures.claims) {
    const bool is_old = claim.age.judged() == Judgement::broken;
    const Judgement judged = is_old ? Judgement::broken : claim.lead.judged();
    const Json entry = {{"device", name_of(result, claim.device)}, {"lead_max_ns", largest(claim.lead)},
                        {"allowed_ns", bound(claim.lead.bound)},   {"age_max_ns", largest(claim.age)},
                        {"age_bound_ns", bound(claim.age.bound)},  {"judged", judgement_name(judged)}};
    const bool was_broken = claim.lead.was_broken || claim.age.was_broken;
    list.push_back(excused(entry, result, {claim.device, {}}, judged, was_broken));
  }
  return list;
}

Json fault_list(const RunResult& result, const std::vector<FaultCount>& faults) {
  Json list = Json::array();
  for (const FaultCount& fault : faults) {
    const FaultMeaning* meaning = meaning_of(result.fault_table, fault);
    list.push_back({{"module", meaning != nullptr ? Json(meaning->module_name) : Json(fault.module)},
                    {"code", fault.number},
                    {"count", fault.count}});
  }
  return list;
}

template <class Amount, class Number>
void add_declared(Json& entry, const std::string& name, const Declared<Amount>& amount, const Number& number) {
  entry[name] = number(amount.seen);
  entry["most_" + name] = amount.most ? Json(number(*amount.most)) : Json(nullptr);
}

/// Null where nobody looked at it.
Json traffic_json(const std::vector<MeasuredTraffic>& all, BusId bus) {
  const MeasuredTraffic* found = find_traffic(all, bus);
  if (found == nullptr) return nullptr;
  const auto ns = [](Duration duration) { return duration.ns(); };
  Json entry{{"window_ns", found->window.ns()}};
  add_declared(entry, "sent_ns", found->sent, ns);
  if (found->received) add_declared(entry, "received_ns", *found->received, ns);
  add_declared(entry, "interrupts", found->interrupts, [](std::int64_t count) { return count; });
  entry["judged"] = judgement_name(found->judged());
  return entry;
}

Json bus_list(const RunResult& result) {
  Json list = Json::array();
  for (const BusRecord& bus : result.record.buses) {
    list.push_back({{"name", result.robot.buses[bus.bus].name.text},
                    {"transfers", bus.transfers},
                    {"errors", bus.errors},
                    {"busy", bus.busy},
                    {"traffic", traffic_json(result.figures.traffic, bus.bus)}});
  }
  return list;
}

Json monitor_list(const RunResult& result) {
  Json list = Json::array();
  for (const MonitorEntry& entry : result.record.monitor) {
    const timing::DeviceBounds& of = result.bounds.devices[entry.device];
    list.push_back({{"device", name_of(result, entry.device)},
                    {"response_max_ns", entry.response_max.ns()},
                    {"response_bound_ns", bound(of.response)},
                    {"age_max_ns", entry.age_max > Duration::zero() ? Json(entry.age_max.ns()) : Json(nullptr)},
                    {"age_bound_ns", bound(of.age)},
                    {"response_violations", entry.response_violations},
                    {"age_violations", entry.age_violations}});
  }
  return list;
}

Json expectation_list(const RunResult& result) {
  Json list = Json::array();
  for (const ExpectationRecord& e : result.record.expectations) {
    list.push_back({{"part", e.part},
                    {"value", e.value},
                    {"from_ns", e.from.ns()},
                    {"to_ns", e.to.ns()},
                    {"min", e.min},
                    {"max", e.max},
                    {"lowest", e.lowest ? Json(*e.lowest) : Json(nullptr)},
                    {"highest", e.highest ? Json(*e.highest) : Json(nullptr)},
                    {"finite", e.finite},
                    {"ok", e.ok}});
  }
  return list;
}

Json image_json(const ImageFacts& image) {
  Json facts{{"sha256", image.sha256}};
  facts.update(sizes_json(image));
  Json parts = Json::array();
  for (const ImageShare& share : image.shares) {
    parts.push_back({{"kind", share_name(share.kind)},
                     {"name", share.name.empty() ? Json(nullptr) : Json(share.name)},
                     {"flash", share.flash},
                     {"ram", share.ram}});
  }
  facts["parts"] = std::move(parts);
  return facts;
}

}  // namespace

Json run_document(const RunResult& result) {
  Json document = {{"schema", "finemote.run/1"},
                   {"image", image_json(result.image)},
                   {"board", result.board},
                   {"duration_ns", result.duration.ns()},
                   {"bringup_ns", result.record.ready.ns()},
                   {"absent", result.record.absent},
                   {"phases", result.phases},
                   {"seed", result.seed},
                   {"stages", stage_list(result)},
                   {"events", event_list(result)},
                   {"chains", chain_list(result)},
                   {"responses", response_list(result)},
                   {"jitter", jitter_list(result)},
                   {"claims", claim_list(result)},
                   {"order",
                    {{"judged", result.order.is_judged},
                     {"mistake", result.order.mistake ? Json(*result.order.mistake) : Json(nullptr)}}},
                   {"loops", loop_list(result.loops, result.record.loop_passes)},
                   {"overruns", result.overruns()},
                   {"resets", result.record.resets},
                   {"buses", bus_list(result)},
                   {"flash", result.record.flash.empty() ? Json(nullptr) : Json(result.record.flash)},
                   {"silicon", result.record.flash.empty() ? Json(nullptr) : silicon_json(result.record.silicon)},
                   {"faults", !result.record.violated.empty()},
                   {"fault_counts", fault_list(result, result.record.faults)},
                   {"unexplained_faults", fault_list(result, result.unexplained_faults())},
                   {"expectations", expectation_list(result)},
                   {"values", value_list(result.record.series)},
                   {"silent", result.record.silent},
                   {"schedulable", result.schedulable ? Json(*result.schedulable) : Json(nullptr)}};
  if (!result.record.monitor.empty()) document["monitor"] = monitor_list(result);
  return document;
}

}  // namespace finemote::gen
