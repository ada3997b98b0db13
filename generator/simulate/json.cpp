#include "generator/simulate/json.hpp"

#include "generator/units/hyperperiod.hpp"

namespace finemote::gen {
namespace {

using timing::Json;

Json number(std::optional<Duration> value) { return value ? Json(value->ns()) : Json(nullptr); }

}  // namespace

Json simulation_json(const timing::Timing& timing, const Simulation& run, const SimulationRequest& request) {
  const auto& bounds = timing.verdict().devices;
  Json out{{"schema", "finemote.simulation/1"},
           {"profile", timing::profile_name(timing.asked)},
           {"seed", request.seed},
           {"duration_ns", run.duration.ns()},
           {"hyperperiod_ns", number(hyperperiod(timing.model.devices))},
           {"devices", Json::array()},
           {"chains", Json::array()},
           {"misses", run.misses}};
  for (const Rank d : run.devices.ids()) {
    out["devices"].push_back(Json{{"name", timing.model.devices[d].name},
                                  {"response_max_ns", number(observed(run.devices[d].response))},
                                  {"window_max_ns", number(observed(run.devices[d].window))},
                                  {"response_bound_ns", number(bounds[d].r_minus)},
                                  {"window_bound_ns", number(bounds[d].window)}});
  }
  for (std::size_t c = 0; c < run.chains.size(); ++c) {
    out["chains"].push_back(Json{{"from", timing.model.devices[run.chains[c].ends.from].name},
                                 {"to", timing.model.devices[run.chains[c].ends.to].name},
                                 {"max_ns", number(observed(run.chains[c].latency))},
                                 {"bound_ns", number(timing.chains[c].decide)}});
  }
  return out;
}

}  // namespace finemote::gen
