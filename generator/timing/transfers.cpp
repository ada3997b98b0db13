#include "generator/timing/transfers.hpp"

#include <algorithm>
#include <set>

#include "generator/timing/demand.hpp"
#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {

std::size_t bucket_of(const TaskSet& set, const Flush& flush) {
  std::size_t w = 0;
  while (set.buckets[w].period != flush.period) ++w;
  return w;
}

bool share_slot(const Flush& a, const Flush& b) {
  return a.bus && a.bus == b.bus && !a.output.empty() && a.output == b.output;
}

TransferBounds::TransferBounds(const Model& model, Profile profile, const TaskSet& set, const Responses& responses,
                               Effort& effort)
    : model_(model), profile_(profile), set_(set), responses_(responses), effort_(effort) {
  collect();
  add_load();
}

/// Time a transfer needs whose wire stands still while it waits for service and while its own routines run. Each of its
/// interrupts waits at most for all interrupt work there can be at once; and all of them together for no more than the
/// interrupt work that arrives while the transfer lasts, plus one masked section each. Both are bounds; the smaller
/// counts. Where its own routines are known, they stand for all that transfers cause on its bus meanwhile.
Duration TransferBounds::with_service(const Item& item, std::int64_t interrupts, Duration service) const {
  if (profile_ != Profile::target || interrupts == 0 || is_saturated(set_, 0)) return item.pure;
  std::vector<Stream> streams = set_.streams;
  if (service > Duration::zero()) {
    service += interrupts * model_.costs.interrupt;
    std::erase_if(streams, [&](const Stream& s) { return s.of_transfers == item.bus; });
  }
  Demand demand(effort_);
  demand.add_streams(streams);
  const auto fixed_point = [&](Duration base) {
    demand.rewind();
    const Duration least = least_fit(demand, base, std::max(base, nanoseconds(1)), kLongest);
    return least == kNever ? closed_fixed_point(set_, 0, base) : least;  // of all streams: never smaller
  };
  const Duration delay = fixed_point(set_.blocking);
  const Duration together = fixed_point(item.pure + service + add(interrupts, 1) * set_.blocking);
  return std::min(item.pure + service + interrupts * delay, together);
}

void TransferBounds::collect() {
  const Responses& r = responses_;
  item_of_.resize(model_.devices.size());
  for (const Rank d : model_.devices.ids()) {
    const std::size_t w = set_.bucket_of[d];
    for (const Transfer& t : model_.devices[d].transfers) {
      Item item{t.bus, t.receive, t.after == Transfer::After::autonomous, model_.devices[d].period, {}, t.wire, {},
                w + 1, r.ok(w)};
      item.bucket = w;
      if (t.after == Transfer::After::update) item.jitter = r.r_plus[d];
      if (t.after == Transfer::After::handle) item.jitter = r.r_minus[d];
      if (t.after == Transfer::After::bucket) item.jitter = r.bucket[w];
      if (item.autonomous) {
        item.rank = 0;
        item.bounded = true;
        if (t.min_interval > Duration::zero()) item.period = t.min_interval;
      }
      if (t.identifier) item.identifiers = {*t.identifier, *t.identifier};
      item_of_[d].push_back(add_item(item, t.interrupts, t.service));
    }
  }
  for (const Flush& f : model_.flushes) {
    flush_item_.emplace_back();
    if (!f.bus) continue;
    const std::size_t w = bucket_of(set_, f);
    // The slot has the urgency of the fastest bucket that fills it, whoever does.
    std::size_t rank = w + 1;
    for (const Flush& other : model_.flushes) {
      if (share_slot(f, other)) rank = std::min(rank, bucket_of(set_, other) + 1);
    }
    Item item{*f.bus, false, false, f.period, r.bucket[w], f.wire, {}, rank, r.ok(w)};
    item.bucket = w;
    if (!f.identifiers.empty()) {
      const auto [first, last] = std::minmax_element(f.identifiers.begin(), f.identifiers.end());
      item.identifiers = {*first, *last};
      item.frames = static_cast<std::int64_t>(f.identifiers.size());
    }
    flush_item_.back() = add_item(item, f.interrupts, f.service);
  }
}

std::size_t TransferBounds::add_item(Item item, std::int64_t interrupts, Duration service) {
  item.pure = item.wire;
  item.wire = with_service(item, interrupts, service);
  item.arbitrated = model_.buses[item.bus].arbitrated;
  if (item.arbitrated) item.rank = 0;
  items_.push_back(item);
  return items_.size() - 1;
}

void TransferBounds::add_load() {
  loads_.resize(model_.buses.size());
  for (const BusPlace b : loads_.ids()) {
    long double lines[2] = {0, 0};
    for (const Item& i : items_) {
      if (i.bus == b)
        lines[i.receive ? 1 : 0] += static_cast<long double>(i.pure.ns()) / static_cast<long double>(i.period.ns());
    }
    const long double load = std::max(lines[0], lines[1]);
    loads_[b] = {nanoseconds(static_cast<std::int64_t>(load * 1e9L + 0.5L)), static_cast<double>(load)};
  }
}

std::optional<Duration> TransferBounds::bound(std::size_t index) const {
  const Item& own = items_[index];
  // What an overloaded bus cannot carry fills mailboxes and queues: then no frame of it is sure of its place.
  if (!own.bounded || loads_[own.bus].utilization > 1) return std::nullopt;
  const auto competes = [&](const Item& i) { return i.bus == own.bus && i.receive == own.receive; };
  Duration blocking = own.on_wire();
  bool alone = true;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    alone &= i == index || !competes(items_[i]);
    if (competes(items_[i]) && items_[i].yields_to(own))
      blocking = std::max(blocking, own.yields_to(items_[i]) ? items_[i].on_wire() : items_[i].frame());
  }
  if (alone) blocking = {};
  const Duration before_last = own.on_wire() - own.frame();  // of its own; more urgent ones may come between
  Duration wait = blocking + before_last;
  for (bool stable = false; !stable;) {
    Duration need = blocking + before_last;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& other = items_[i];
      // Of equal rank the order of the slots decides; counting both ways is safe.
      if (i == index || !competes(other) || !own.yields_to(other)) continue;
      if (!other.bounded) return std::nullopt;
      need += (floor_div(wait + other.jitter, other.period) + 1) * other.on_wire();
    }
    const bool goes_on = effort_.spend(static_cast<std::int64_t>(items_.size()));
    if (need > own.period || !goes_on) return std::nullopt;
    stable = need <= wait;
    wait = std::max(wait, need);
  }
  // The slot must be free again before it is filled the next time. That of a part that sends by itself, and the mailbox
  // of a controller that arbitrates, are free when the frame has left the wire, whenever it is served.
  if (wait + own.frame() + own.jitter > own.period) return std::nullopt;
  return wait + own.wire - before_last;
}

std::optional<Duration> TransferBounds::of(Rank device, std::size_t transfer) const {
  return bound(item_of_[device][transfer]);
}

std::optional<Duration> TransferBounds::of_flush(std::size_t flush) const {
  return flush_item_[flush] ? bound(*flush_item_[flush]) : Duration::zero();
}

Table<BusPlace, std::vector<std::optional<Duration>>> TransferBounds::ended() const {
  Table<BusPlace, std::vector<std::optional<Duration>>> all;
  for (std::size_t b = 0; b < model_.buses.size(); ++b)
    all.push_back(std::vector<std::optional<Duration>>(set_.buckets.size()));
  std::set<std::pair<BusPlace, std::size_t>> unknown;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    if (item.autonomous || unknown.contains({item.bus, item.bucket})) continue;
    std::optional<Duration>& end = all[item.bus][item.bucket];
    const std::optional<Duration> last = bound(i);
    if (last && item.jitter + *last <= item.period) {
      end = std::max(end.value_or(Duration::zero()), item.jitter + *last);
    } else {
      end = std::nullopt;
      unknown.insert({item.bus, item.bucket});
    }
  }
  return all;
}

}  // namespace finemote::gen::timing
