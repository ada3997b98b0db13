#include "generator/timing/task_set.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "generator/timing/one_wire.hpp"

namespace finemote::gen::timing {
namespace {

bool are_alike(const Stream::Budget& a, const Stream::Budget& b) {
  return a.period == b.period && a.carry_in == b.carry_in && a.every == 1 && b.every == 1 && a.jitter == b.jitter &&
         a.kind == b.kind && a.separation == b.separation && a.most == kUnlimited && b.most == kUnlimited;
}

bool is_free(const Stream& stream) { return stream.cost == Duration::zero(); }

Stream::Budget budget_of(const Model& model, const FrameBudget& b) {
  Stream::Budget budget;
  budget.count = b.count;
  budget.period = b.interval > Duration::zero() ? b.interval : model.devices[b.device].period;
  budget.carry_in = b.carry_in;
  budget.every = b.every;
  budget.cause = b.cause;
  budget.asked_in = b.asked_in;
  budget.device = b.device;
  // One transfer may be under way when a window begins, and one job more than the window has periods may ask in it. So
  // it is on CAN: frames in mailboxes may be more, but the end of one interrupts only where another one waits in a
  // slot.
  if (b.cause == InterruptCause::transfer) budget.lasting = b.every;
  budget.carry_in = add(budget.carry_in, budget.lasting);
  return budget;
}

void add_sources(const Model& model, Profile profile, TaskSet& set) {
  const Duration entry = profile == Profile::target ? model.costs.interrupt : Duration::zero();
  for (const BusPlace place : model.buses.ids()) {
    const Bus& bus = model.buses[place];
    if (profile != Profile::target || !bus.sources) {
      const Duration separation = profile == Profile::paper ? std::min(bus.frame, model.tick) : bus.frame;
      set.sources.push_back(
          {separation, bus.wcet > Duration::zero() ? bus.wcet + entry : Duration::zero(), {}, bus.name, bus.name, ""});
      continue;
    }
    for (const InterruptSource& source : *bus.sources) {
      const Duration cost = source.steals ? source.wcet : source.wcet + entry;
      Stream stream{source.min_interval, cost, {}, bus.name + "." + source.name, bus.name, source.name, place};
      stream.of_transfers = source.of_transfers;
      stream.ends_frame = source.ends_frame;
      for (const FrameBudget& b : source.budgets) stream.budgets.push_back(budget_of(model, b));
      (source.steals ? set.dma : set.sources).push_back(std::move(stream));
    }
  }
  std::erase_if(set.sources, is_free);
  std::erase_if(set.dma, is_free);
}

void add_bus_streams(const Model& model, TaskSet& set) {
  for (auto begin = set.sources.begin(); begin != set.sources.end();) {
    const auto is_of_other = [&](const Stream& stream) { return !stream.place || stream.place != begin->place; };
    const auto end = std::find_if(begin + 1, set.sources.end(), is_of_other);
    const std::int64_t rate = begin->place ? model.buses[*begin->place].baud_bps : 1;
    for (Stream& stream : one_wire({begin, end}, ceil_div(seconds(1), rate))) set.streams.push_back(std::move(stream));
    begin = end;
  }
  set.streams.insert(set.streams.end(), set.dma.begin(), set.dma.end());
}

/// The release interrupt runs at the releases of the buckets: in any window of length L at most
/// ceil(L/gcd of the periods) times, and at most sum ceil(L/period) times. It costs more for every bucket due. Where
/// the timer cannot count to the next release it runs in between, too: from one such instant to the next, and from a
/// release to the next such instant, it counts as long as it can.
void add_release_streams(const Model& model, TaskSet& set) {
  Duration distance;
  Stream release{nanoseconds(1), model.costs.release, {}, "release"};
  for (const TaskBucket& bucket : set.buckets) {
    distance = gcd(distance, bucket.period);
    Stream::Budget& once = release.budgets.emplace_back();
    once.count = 1;
    once.period = bucket.period;
    set.streams.push_back({bucket.period, model.costs.release_per_bucket, {}, "release"});
  }
  if (model.costs.longest_release > Duration::zero())
    set.streams.push_back({model.costs.longest_release, model.costs.release, {}, "release"});
  release.separation = distance;
  if (distance == set.buckets.front().period) release.budgets.clear();
  set.streams.push_back(std::move(release));
}

void add_buckets(const Model& model, Profile profile, TaskSet& set) {
  std::map<Duration, std::vector<Rank>> by_period;
  for (const Rank d : model.devices.ids()) by_period[model.devices[d].period].push_back(d);
  set.bucket_of.resize(model.devices.size());
  set.place_of.resize(model.devices.size());
  for (auto& [period, devices] : by_period) {
    TaskBucket bucket;
    bucket.period = period;
    std::size_t place = 0;
    for (const Rank d : devices) {
      set.bucket_of[d] = set.buckets.size();
      set.place_of[d] = place++;
      bucket.cost += set.update[d] + set.handle[d];
    }
    if (profile == Profile::target) {
      bucket.before = model.costs.job;
      for (const Flush& f : model.flushes) bucket.after += (f.period == period ? f.wcet : Duration::zero());
      bucket.cost += bucket.before + bucket.after;
    }
    bucket.devices = std::move(devices);
    set.buckets.push_back(std::move(bucket));
  }
}

}  // namespace

void join_alike(std::vector<Stream::Budget>& budgets) {
  const auto key = [](const Stream::Budget& b) {
    return std::tuple(b.most, b.every, b.period, b.jitter, b.carry_in, b.kind, b.separation);
  };
  std::stable_sort(budgets.begin(), budgets.end(),
                   [&](const Stream::Budget& a, const Stream::Budget& b) { return key(a) < key(b); });
  std::vector<Stream::Budget> joined;
  for (const Stream::Budget& budget : budgets) {
    if (!joined.empty() && are_alike(joined.back(), budget)) {
      joined.back().count = add(joined.back().count, budget.count);
    } else {
      joined.push_back(budget);
    }
  }
  budgets = std::move(joined);
}

Duration TaskSet::lag(Duration stage, Duration consumer_period) const {
  if (least_lag == Duration::zero() || stage > Duration::zero()) return {};
  const auto consumer = std::find_if(buckets.begin(), buckets.end(),
                                     [&](const TaskBucket& bucket) { return bucket.period == consumer_period; });
  return consumer->cost == Duration::zero() ? least_lag : Duration::zero();
}

TaskSet make_task_set(const Model& model, Profile profile) {
  TaskSet set;
  const bool target = profile == Profile::target;
  for (const Device& d : model.devices) {
    set.update.push_back(target ? d.update_wcet + d.update_extra + model.costs.stage : d.update_wcet);
    set.handle.push_back(target ? d.handle_wcet + d.handle_extra + model.costs.stage : d.handle_wcet);
  }
  add_buckets(model, profile, set);
  const std::vector<std::optional<Duration>> unknown(set.buckets.size());
  set.ended = Table<BusPlace, std::vector<std::optional<Duration>>>(model.buses.size(), unknown);
  add_sources(model, profile, set);
  add_bus_streams(model, set);
  set.bus_streams = set.streams.size();
  if (target) {
    add_release_streams(model, set);
    set.blocking = model.costs.masked;
  }
  // Reads may ask for an order that the trees rule out.
  const bool has_reads =
      std::any_of(model.devices.begin(), model.devices.end(), [](const Device& d) { return !d.reads.empty(); });
  if (target || has_reads) set.least_lag = nanoseconds(1);
  std::erase_if(set.streams, is_free);
  return set;
}

}  // namespace finemote::gen::timing
