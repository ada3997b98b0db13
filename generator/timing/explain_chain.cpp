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
      finding_.note(fmt::format("acquire {} + decide {} + wire {}, from '{}' to '{}'", text(chain_.acquire),
                                text(chain_.decide), text(chain_.wire), from, to));
    }
    const auto is_largest = [&](std::optional<Duration> part) {
      return part == std::max({chain_.acquire.value_or(Duration::zero()), chain_.decide.value_or(Duration::zero()),
                               chain_.wire.value_or(Duration::zero())});
    };
    if (decision_only || !chain_.decide) return explain_decide();
    if (!chain_.acquire) return explain_unbounded(ChainPart::acquire, sample_bus(model_, chain_.from));
    if (!chain_.wire) return explain_unbounded(ChainPart::wire, command_bus(model_, chain_.to));
    if (is_largest(chain_.decide)) return explain_decide("decide is the largest part: ");
    if (is_largest(chain_.acquire)) return explain_acquire();
    explain_wire();
  }

 private:
  static std::string text(std::optional<Duration> time) { return time ? readable_duration(*time) : "without bound"; }

  void explain_unbounded(ChainPart part, std::optional<BusPlace> bus) {
    if (!bus) return;
    const std::string undeclared = undeclared_text(model_, *bus);
    if (!undeclared.empty()) return void(finding_.note(fmt::format("{}: {}", part_name(part), undeclared)));
    finding_.note(
        fmt::format("{}: on bus '{}' a message may still be queued when the next one is due; the bus needs {} "
                    "of its capacity",
                    part_name(part), model_.buses[*bus].name, whole_percent(timing_.bus_loads[*bus].utilization)));
  }
  void explain_acquire() {
    const Device& device = model_.devices[chain_.from];
    const bool streams = device.acquisition && device.acquisition->periods == 0;
    if (streams) {
      finding_.note(fmt::format("acquire is the largest part: how old what '{}' sends can be", device.name));
      return;
    }
    finding_.note(fmt::format("acquire is the largest part: {} periods of '{}' ({}) for one measurement",
                              std::max<std::int64_t>(floor_div(*chain_.acquire, device.period), 1), device.name,
                              readable_duration(device.period)));
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
    if (!chain_.decide) {
      finding_.note("decide has no bound: devices on the way may miss their deadline");
      return;
    }
    const std::vector<Rank> way = devices_between(model_, chain_);
    const auto period = [&](Rank d) { return model_.devices[d].period; };
    const auto [fastest, slowest] =
        std::minmax_element(way.begin(), way.end(), [&](Rank a, Rank b) { return period(a) < period(b); });
    if (*chain_.decide >= period(*fastest)) {  // waiting for the next job, more than working
      finding_.note(fmt::format("{}'{}' runs every {}, the slowest on the way", decide, model_.devices[*slowest].name,
                                readable_duration(period(*slowest))));
      return;
    }
    const Device& device = model_.devices[busiest_within(period(*slowest))];
    finding_.note(fmt::format("{}of what runs every {} or more often, '{}' takes longest: update {}, handle {}", decide,
                              readable_duration(period(*slowest)), device.name, readable_duration(device.update_wcet),
                              readable_duration(device.handle_wcet)));
  }
  [[nodiscard]] Rank busiest_within(Duration period) const {
    Rank busiest = chain_.from;
    Duration most = nanoseconds(-1);
    for (const Rank d : model_.devices.ids()) {
      const Device& device = model_.devices[d];
      if (device.period > period || device.update_wcet + device.handle_wcet <= most) continue;
      most = device.update_wcet + device.handle_wcet;
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
