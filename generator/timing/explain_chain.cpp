#include "generator/timing/explain_chain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/shares.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

using units::readable_duration;

class ChainExplainer {
 public:
  ChainExplainer(const Timing& timing, const ChainResult& chain, Diagnostic& finding)
      : timing_(timing), model_(timing.model), chain_(chain), finding_(finding) {}

  void explain(bool decision_only) {
    const std::string &from = model_.devices[chain_.from].name, &to = model_.devices[chain_.to].name;
    if (!decision_only) {
      finding_.note(fmt::format("acquire {} + decide {} + wire {}, from '{}' to '{}'", text(chain_.acquire_ns),
                                text(chain_.decide_ns), text(chain_.wire_ns), from, to));
    }
    const auto is_largest = [&](std::optional<Ns> part) {
      return part ==
             std::max({chain_.acquire_ns.value_or(0), chain_.decide_ns.value_or(0), chain_.wire_ns.value_or(0)});
    };
    if (decision_only || !chain_.decide_ns) return explain_decide();
    if (!chain_.acquire_ns) return explain_unbounded("acquire", sample_bus(model_, chain_.from));
    if (!chain_.wire_ns) return explain_unbounded("wire", command_bus(model_, chain_.to));
    if (is_largest(chain_.decide_ns)) return explain_decide("decide is the largest part: ");
    if (is_largest(chain_.acquire_ns)) return explain_acquire();
    explain_wire();
  }

 private:
  static std::string text(std::optional<Ns> ns) { return ns ? readable_duration(*ns) : "without bound"; }

  void explain_unbounded(const char* part, std::optional<BusPlace> bus) {
    if (!bus) return;
    finding_.note(
        fmt::format("{}: on bus '{}' a message may still wait when the next one is due; the bus needs {} "
                    "of its capacity",
                    part, model_.buses[*bus].name, whole_percent(timing_.bus_loads[*bus].utilization)));
  }
  void explain_acquire() {
    const Device& device = model_.devices[chain_.from];
    const bool streams = device.acquisition && device.acquisition->periods == 0;
    if (streams) {
      finding_.note(fmt::format("acquire is the largest part: how old what '{}' sends can be", device.name));
      return;
    }
    finding_.note(fmt::format("acquire is the largest part: {} periods of '{}' ({}) for one measurement",
                              std::max<Ns>(*chain_.acquire_ns / device.period_ns, 1), device.name,
                              readable_duration(device.period_ns)));
  }
  void explain_wire() {
    const auto bus = command_bus(model_, chain_.to);
    const std::string& to = model_.devices[chain_.to].name;
    if (!bus) {
      finding_.note(fmt::format("wire is the largest part: the output of '{}' itself", to));
      return;
    }
    finding_.note(fmt::format("wire is the largest part: the command of '{}' goes over bus '{}', busy for {}", to,
                              model_.buses[*bus].name, whole_percent(timing_.bus_loads[*bus].utilization)));
  }
  void explain_decide(const char* decide = "") {
    if (!chain_.decide_ns) {
      finding_.note("decide has no bound: devices on the way may miss their deadline");
      return;
    }
    const std::vector<Rank> way = devices_between(model_, chain_);
    const auto period = [&](Rank d) { return model_.devices[d].period_ns; };
    const auto [fastest, slowest] =
        std::minmax_element(way.begin(), way.end(), [&](Rank a, Rank b) { return period(a) < period(b); });
    if (*chain_.decide_ns >= period(*fastest)) {  // waiting for the next job, more than working
      finding_.note(fmt::format("{}'{}' runs every {}, the slowest on the way", decide, model_.devices[*slowest].name,
                                readable_duration(period(*slowest))));
      return;
    }
    const Device& device = model_.devices[busiest_within(period(*slowest))];
    finding_.note(fmt::format("{}of what runs every {} or more often, '{}' takes longest: update {}, handle {}", decide,
                              readable_duration(period(*slowest)), device.name,
                              readable_duration(device.update_wcet_ns), readable_duration(device.handle_wcet_ns)));
  }
  [[nodiscard]] Rank busiest_within(Ns period) const {
    Rank busiest = chain_.from;
    Ns most = -1;
    for (const Rank d : model_.devices.ids()) {
      const Device& device = model_.devices[d];
      if (device.period_ns > period || add(device.update_wcet_ns, device.handle_wcet_ns) <= most) continue;
      most = add(device.update_wcet_ns, device.handle_wcet_ns);
      busiest = d;
    }
    return busiest;
  }

  const Timing& timing_;
  const Model& model_;
  const ChainResult& chain_;
  Diagnostic& finding_;
};

}  // namespace

void explain_chain(const Timing& timing, const ChainResult& chain, bool decision_only, Diagnostic& finding) {
  ChainExplainer(timing, chain, finding).explain(decision_only);
}

}  // namespace finemote::gen::timing
