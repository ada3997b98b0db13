#include "generator/timing/traffic_limits.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"

namespace finemote::gen::timing {
namespace {

/// How often what comes once in a period can be under way in a window: as often as it comes, and what was begun before.
std::int64_t times_in(Duration window, Duration period) { return add(ceil_div(window, period), 2); }

/// Where somebody sends what is not declared, the wire has no limit.
class Wires {
 public:
  Wires(const Model& model, Duration window) : window_(window), limits_(model.buses.size()) {
    for (TrafficLimit& limit : limits_) limit.wire = limit.received = Duration::zero();
    for (const Device& device : model.devices) {
      for (const Transfer& transfer : device.transfers) add_transfer(device, transfer);
    }
    for (const Flush& flush : model.flushes) {
      if (flush.bus) add(limits_[*flush.bus].wire, flush.wire, flush.period);
    }
    for (const Device& device : model.devices) {
      for (const BusPlace bus : device.undeclared) limits_[bus].wire = limits_[bus].received = std::nullopt;
    }
  }

  [[nodiscard]] Table<BusPlace, TrafficLimit> limits() && { return std::move(limits_); }

 private:
  void add_transfer(const Device& device, const Transfer& transfer) {
    const bool has_own_interval = transfer.min_interval > Duration::zero();
    const Duration period = has_own_interval ? transfer.min_interval : device.period;
    if (!transfer.receive) add(limits_[transfer.bus].wire, transfer.wire, period);
    if (transfer.receive || transfer.reads) add(limits_[transfer.bus].received, transfer.wire, period);
  }

  void add(std::optional<Duration>& limit, Duration wire, Duration period) const {
    *limit += times_in(window_, period) * wire;
  }

  Duration window_;
  Table<BusPlace, TrafficLimit> limits_;
};

/// Work of the bus where each run of a routine is one nanosecond.
std::int64_t most_runs(std::vector<Stream> streams, Duration window) {
  for (Stream& stream : streams) stream.cost = nanoseconds(1);
  Effort effort;
  Demand demand(effort);
  demand.add_streams(streams);
  return demand.at(window).ns();
}

/// A routine without a cost is in no task set.
bool counts_all(const Bus& bus) {
  return bus.sources && std::all_of(bus.sources->begin(), bus.sources->end(),
                                    [](const InterruptSource& s) { return s.wcet > Duration::zero(); });
}

}  // namespace

Table<BusPlace, TrafficLimit> traffic_limits(const Model& model, Duration window) {
  Table<BusPlace, TrafficLimit> limits = Wires(model, window).limits();
  const TaskSet set = make_task_set(model, Profile::target);
  for (const BusPlace bus : limits.ids()) {
    if (!counts_all(model.buses[bus])) continue;
    std::vector<Stream> own;
    std::copy_if(set.sources.begin(), set.sources.end(), std::back_inserter(own),
                 [&](const Stream& stream) { return stream.place == bus; });
    limits[bus].interrupts = most_runs(std::move(own), window);
  }
  return limits;
}

}  // namespace finemote::gen::timing
