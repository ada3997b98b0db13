#include "generator/timing/wire.hpp"

#include <algorithm>

#include "generator/timing/rest_of_job.hpp"
#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {
namespace {

bool share_slot(const Flush& a, const Flush& b) {
  return a.bus && a.bus == b.bus && !a.output.empty() && a.output == b.output;
}

/// Whether this transfer can bring a sample: a device that asks for nothing in update() may do so together with its
/// command.
bool measures(const Device& device, const Transfer& transfer) {
  const auto is_of_update = [](const Transfer& other) { return other.after == Transfer::After::update; };
  return !transfer.command || std::none_of(device.transfers.begin(), device.transfers.end(), is_of_update);
}

}  // namespace

WireAnalysis::WireAnalysis(const Model& model, const ProfileAnalysis& profile, Effort& effort)
    : model_(model), profile_(profile), effort_(effort) {
  collect();
  add_load();
}

/// Time a transfer needs whose wire stands still while it waits for service and while its own routines run. Each of its
/// interrupts waits at most for all interrupt work there can be at once; and all of them together for no more than the
/// interrupt work that arrives while the transfer lasts, plus one masked section each. Both are bounds; the smaller
/// counts. Where its own routines are known, they stand for all that transfers cause on its bus meanwhile.
Duration WireAnalysis::with_service(const Item& item, std::int64_t interrupts, Duration service) {
  const TaskSet& set = profile_.set;
  if (profile_.result.profile != Profile::target || interrupts == 0 || is_saturated(set, 0)) return item.pure;
  std::vector<Stream> streams = set.streams;
  if (service > Duration::zero()) {
    service += interrupts * model_.costs.interrupt;
    std::erase_if(streams, [&](const Stream& s) { return s.of_transfers == item.bus; });
  }
  Demand demand(effort_);
  demand.add_streams(streams);
  const auto fixed_point = [&](Duration base) {
    demand.rewind();
    const Duration least = least_fit(demand, base, std::max(base, nanoseconds(1)), kLongest);
    return least == kNever ? closed_fixed_point(set, 0, base) : least;  // of all streams: never smaller
  };
  const Duration delay = fixed_point(set.blocking);
  const Duration together = fixed_point(item.pure + service + add(interrupts, 1) * set.blocking);
  return std::min(item.pure + service + interrupts * delay, together);
}

void WireAnalysis::collect() {
  const Responses& r = profile_.responses;
  item_of_.resize(model_.devices.size());
  const auto add_item = [&](Item item, std::int64_t interrupts, Duration service) {
    item.pure = item.wire;
    item.wire = with_service(item, interrupts, service);
    item.arbitrated = model_.buses[item.bus].arbitrated;
    if (item.arbitrated) item.rank = 0;
    items_.push_back(item);
    return items_.size() - 1;
  };
  for (const Rank d : model_.devices.ids()) {
    const std::size_t w = profile_.set.bucket_of[d];
    for (const Transfer& t : model_.devices[d].transfers) {
      Item item{t.bus, t.receive, t.after == Transfer::After::autonomous, model_.devices[d].period, {}, t.wire, {},
                w + 1, r.ok(w)};
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
    const std::size_t w = bucket_of(f);
    // The slot has the urgency of the fastest bucket that fills it, whoever does.
    std::size_t rank = w + 1;
    for (const Flush& other : model_.flushes) {
      if (share_slot(f, other)) rank = std::min(rank, bucket_of(other) + 1);
    }
    Item item{*f.bus, false, false, f.period, r.bucket[w], f.wire, {}, rank, r.ok(w)};
    if (!f.identifiers.empty()) {
      const auto [first, last] = std::minmax_element(f.identifiers.begin(), f.identifiers.end());
      item.identifiers = {*first, *last};
      item.frames = static_cast<std::int64_t>(f.identifiers.size());
    }
    flush_item_.back() = add_item(item, f.interrupts, f.service);
  }
}

std::size_t WireAnalysis::bucket_of(const Flush& flush) const {
  std::size_t w = 0;
  while (profile_.set.buckets[w].period != flush.period) ++w;
  return w;
}

void WireAnalysis::add_load() {
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

std::optional<Duration> WireAnalysis::bound(std::size_t index) const {
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

std::optional<Duration> WireAnalysis::response(Rank device, std::size_t transfer) const {
  return bound(item_of_[device][transfer]);
}

/// One slot filled by several buckets. A flush leaves its data behind where the slot is still taken, or where it
/// preempts another flush. With L the longest time a flush lasts and w the longest a transfer does: what was handed
/// over without our data is handed over within L and over after another w; a flush that began before that has ended
/// after another L. The next flush of the fastest bucket (within T + R) sends our data, or finds them sent, or preempts
/// a flush that sends them within L.
std::optional<Duration> WireAnalysis::flush_response(std::size_t flush) const {
  if (!flush_item_[flush]) return Duration::zero();
  const Flush& own = model_.flushes[flush];
  std::size_t sharers = 0, fastest = bucket_of(own);
  Duration wire, last;
  for (std::size_t f = 0; f < model_.flushes.size(); ++f) {
    if (f != flush && !share_slot(own, model_.flushes[f])) continue;
    const auto transfer = bound(*flush_item_[f]);
    const std::size_t bucket = bucket_of(model_.flushes[f]);
    const Duration response = profile_.responses.bucket[bucket];
    const auto end = end_of_job(bucket, {}, response, [response](Duration) { return response; });
    if (!transfer || !end) return std::nullopt;
    wire = std::max(wire, *transfer);
    last = std::max(last, *end);
    fastest = std::min(fastest, bucket_of(model_.flushes[f]));
    ++sharers;
  }
  if (sharers == 1) return wire;
  const Duration next = profile_.set.buckets[fastest].period + profile_.responses.bucket[fastest];
  return 2 * wire + 3 * last + next;
}

/// From the end of handle(device) to the end of the job.
std::optional<Duration> WireAnalysis::rest_of_job(Rank device) const {
  const TaskSet& set = profile_.set;
  const std::size_t w = set.bucket_of[device];
  Duration handles;
  for (const Rank d : set.buckets[w].devices) {
    if (d < device) handles += set.handle[d];
  }
  return end_of_job(w, handles, profile_.responses.r_minus[device],
                    [&](Duration release) { return profile_.table.r_minus(device, release); });
}

/// The same from where so much of its handles is left, and the flush.
std::optional<Duration> WireAnalysis::end_of_job(std::size_t w, Duration handles, Duration latest,
                                                 const std::function<Duration(Duration release)>& of) const {
  if (!profile_.responses.ok(w)) return std::nullopt;
  const Duration work = profile_.set.buckets[w].after + profile_.set.blocking + handles;
  return RestOfJob(profile_.set, profile_.responses, effort_).from(w, work, latest, of);
}

std::optional<Duration> WireAnalysis::command(Rank to) const {
  std::optional<Duration> worst = model_.devices[to].output;
  const auto raise = [&](std::optional<Duration> value) {
    worst = worst && value ? std::optional<Duration>(std::max(*worst, *value)) : std::nullopt;
  };
  const auto after_job = [&](std::optional<Duration> value) {
    const auto rest = rest_of_job(to);
    raise(rest && value ? std::optional<Duration>(*rest + *value) : std::nullopt);
  };
  for (std::size_t t = 0; t < model_.devices[to].transfers.size(); ++t) {
    const Transfer& transfer = model_.devices[to].transfers[t];
    if (!transfer.command) continue;
    if (transfer.after == Transfer::After::bucket) {
      after_job(response(to, t));
    } else {
      raise(response(to, t));
    }
  }
  for (std::size_t f = 0; f < model_.flushes.size(); ++f) {
    const auto& devices = model_.flushes[f].devices;
    if (std::find(devices.begin(), devices.end(), to) != devices.end()) after_job(flush_response(f));
  }
  return worst;
}

std::optional<Duration> WireAnalysis::acquisition(Rank from) const {
  const Device& device = model_.devices[from];
  if (!device.acquisition) return Duration::zero();
  const Acquisition& a = *device.acquisition;
  if (a.periods == 0) {
    Duration wire;
    for (std::size_t t = 0; t < device.transfers.size(); ++t) {
      if (device.transfers[t].after != Transfer::After::autonomous) continue;
      const auto bound = response(from, t);
      if (!bound) return std::nullopt;
      wire = std::max(wire, *bound);
    }
    return a.fixed + a.interval + wire;
  }
  const std::size_t w = profile_.set.bucket_of[from];
  if (!profile_.responses.ok(w)) return std::nullopt;
  Duration busy;  // from the release on, until what was asked for has come
  for (std::size_t t = 0; t < device.transfers.size(); ++t) {
    const Transfer& transfer = device.transfers[t];
    if (transfer.after == Transfer::After::autonomous || !measures(device, transfer)) continue;
    const auto bound = response(from, t);
    if (!bound) return std::nullopt;
    const bool is_early = transfer.after == Transfer::After::update;
    busy = std::max(busy, (is_early ? profile_.responses.r_plus : profile_.responses.r_minus)[from] + *bound);
  }
  const Duration response = profile_.responses.r_plus[from];
  busy = std::max(busy, response) + a.conversion;
  const std::int64_t extra = std::max<std::int64_t>(ceil_div(busy, device.period) - 1, 0);
  // Measured in `periods` and published then; read until just before the next one that is published, of which each
  // measurement takes 1 + extra periods and `every` of them one value.
  const std::int64_t periods = add(add(a.periods, extra), multiply(a.every, extra + 1) - 1);
  return a.fixed + response + periods * device.period;
}

}  // namespace finemote::gen::timing
