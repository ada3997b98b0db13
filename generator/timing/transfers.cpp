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
    : model_(model),
      profile_(profile),
      set_(set),
      responses_(responses),
      effort_(effort),
      streams_(set.streams),
      is_saturated_(is_saturated(set, 0)) {
  for (Stream& stream : streams_) join_alike(stream.budgets);
  collect();
  add_load();
}

/// Time a transfer needs whose wire stands still while it waits for service and while its own routines run. Each of its
/// interrupts waits at most for all interrupt work there can be at once; and all of them together for no more than the
/// interrupt work that arrives while the transfer lasts, plus one masked section each. Both are bounds; the smaller
/// counts. Where its own routines are known, they stand for all that transfers cause on its bus meanwhile.
Duration TransferBounds::with_service(const Item& item, std::int64_t interrupts, Duration service) const {
  if (profile_ != Profile::target || interrupts == 0 || is_saturated_) return item.pure;
  std::vector<Stream> streams = streams_;
  if (service > Duration::zero()) {
    service += interrupts * model_.costs.interrupt;
    std::erase_if(streams, [&](const Stream& s) { return s.of_transfers && s.place == item.bus; });
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

/// Of a part on a bus that arbitrates, after its question: a part may answer as late as a measurement takes. What
/// answers a frame that several devices fill comes when that one has left, which it has before the next one.
Duration TransferBounds::latest_answer(const Device& device, const Transfer& transfer) const {
  const bool answers = transfer.reads && transfer.after != Transfer::After::autonomous;
  if (!answers || !model_.buses[transfer.bus].arbitrated) return {};
  const Duration thinking = device.acquisition ? device.acquisition->conversion : Duration::zero();
  return thinking + (transfer.writes || transfer.slot != 0 ? Duration::zero() : device.period);
}

void TransferBounds::collect() {
  const Responses& r = responses_;
  is_declared_ = Table<BusPlace, bool>(model_.buses.size(), true);
  for (const Device& device : model_.devices) {
    for (const BusPlace bus : device.undeclared) is_declared_[bus] = false;
  }
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
      item.is_split = t.frames > 1;
      item.late = latest_answer(model_.devices[d], t);
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
  add_looks();
}

/// A look comes with every job of the fastest bucket. While it is under way it keeps others from looking, and ends when
/// the job that looks does, at the latest: one of any bucket that uses the bus.
void TransferBounds::add_looks() {
  for (const BusPlace bus : model_.buses.ids()) {
    if (!model_.buses[bus].polled || set_.buckets.empty()) continue;
    Duration longest = responses_.bucket.front();
    bool is_bounded = responses_.ok(0);
    for (const Item& item : items_) {
      if (item.bus != bus) continue;
      longest = std::max(longest, responses_.bucket[item.bucket]);
      is_bounded = is_bounded && responses_.ok(item.bucket);
    }
    for (Item& item : items_) {
      if (item.bus != bus) continue;
      item.look = is_bounded ? set_.buckets.front().period + longest : Duration::zero();
      item.bounded = item.bounded && is_bounded;
    }
  }
}

std::size_t TransferBounds::add_item(Item item, std::int64_t interrupts, Duration service) {
  item.pure = item.wire;
  item.wire = with_service(item, interrupts, service);
  item.arbitrated = model_.buses[item.bus].arbitrated;
  if (item.arbitrated) {
    item.rank = 0;
    item.bit = ceil_div(seconds(1), model_.buses[item.bus].baud_bps);
  }
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

bool TransferBounds::competes(const Item& item, const Item& own) {
  return item.bus == own.bus && item.receive == own.receive;
}

/// The longest that may just have begun when something else is handed over: it yields to that, but is not broken off.
Duration TransferBounds::blocking(const Item& own) const {
  Duration longest;
  for (const Item& item : items_) {
    if (&item == &own || !competes(item, own) || !item.yields_to(own) || own.yields_to(item)) continue;
    longest = std::max(longest, item.frame());
  }
  return longest;
}

/// The time on the wire of all that is handed over within `time` and goes before `own`, with or without what comes at
/// its first instant; none where there may be any amount. Of equal rank the order of the slots decides; counting both
/// ways is safe.
std::optional<Duration> TransferBounds::more_urgent(const Item& own, Duration time, bool with_begin) const {
  Duration total;
  for (const Item& item : items_) {
    if (&item == &own || !competes(item, own) || !own.yields_to(item)) continue;
    if (!item.bounded) return std::nullopt;
    const Duration span = time + item.jitter + item.late + own.bit;
    total += (with_begin ? floor_div(span, item.period) + 1 : ceil_div(span, item.period)) * item.on_wire();
  }
  return total;
}

/// Least fixed point of `base` and all that goes before `own`; none above `limit`. What arrives exactly then counts
/// where it goes first.
std::optional<Duration> TransferBounds::least_wait(const Item& own, Duration base, Duration limit,
                                                   bool with_begin) const {
  for (Duration wait = base;;) {
    const auto others = more_urgent(own, wait, with_begin);
    const bool goes_on = effort_.spend(static_cast<std::int64_t>(items_.size()));
    if (!others || !goes_on || base + *others > limit) return std::nullopt;
    if (base + *others <= wait) return wait;
    wait = base + *others;
  }
}

/// One wait on an idle bus comes first. The one before can delay it only where the bus stays busy from that one on:
/// where it is idle before the next is handed over, it cannot (Davis et al. 2007, section 3.2: one instance in the busy
/// period). Else its own length stands for what is pushed through.
Duration TransferBounds::at_begin(const Item& own) const {
  const Duration other = blocking(own);
  const auto busy = least_wait(own, other + own.on_wire(), own.period, false);
  return busy && *busy + own.jitter <= own.period ? other : std::max(other, own.on_wire());
}

/// From hand-over to the start of the last of its frames, less the time of those before that one.
std::optional<Duration> TransferBounds::wait(const Item& own) const {
  // What an overloaded bus cannot carry fills mailboxes and queues: then no frame of it is sure of its place.
  if (!own.bounded || loads_[own.bus].utilization > 1 || !is_declared_[own.bus]) return std::nullopt;
  const bool alone = std::none_of(items_.begin(), items_.end(),
                                  [&](const Item& item) { return &item != &own && competes(item, own); });
  // Of its own; more urgent ones may come between. Of a question and its answer the last may be the shorter one.
  const Duration before_last = own.is_split ? own.on_wire() : own.on_wire() - own.frame();
  const Duration begin = alone ? Duration::zero() : at_begin(own) + own.look;
  const auto wait = least_wait(own, begin + before_last, own.period, true);
  // The slot must be free again before it is filled the next time. That of a part that sends by itself, and the mailbox
  // of a controller that arbitrates, are free when the frame has left the wire, whenever it is served.
  const Duration last = own.is_split ? Duration::zero() : own.frame();  // else it is in the wait
  if (!wait || *wait + last + own.jitter > own.period) return std::nullopt;
  return *wait - before_last;
}

/// Where identifiers decide between our frames, there are no more of them than mailboxes (robot_flushes.cpp). Then one
/// is free, unless a frame is still in another when the next of the same slot comes.
bool TransferBounds::finds_mailbox(const Item& own) const {
  return !own.arbitrated || own.autonomous || !own.identifiers || all_leave(own.bus);
}

bool TransferBounds::all_leave(BusPlace bus) const {
  return std::all_of(items_.begin(), items_.end(),
                     [&](const Item& item) { return item.bus != bus || item.autonomous || wait(item).has_value(); });
}

std::optional<Duration> TransferBounds::bound(std::size_t index) const {
  const Item& own = items_[index];
  const auto before = wait(own);
  return before && finds_mailbox(own) ? std::optional<Duration>(*before + own.wire) : std::nullopt;
}

std::optional<Duration> TransferBounds::of(Rank device, std::size_t transfer) const {
  return bound(item_of_[device][transfer]);
}

std::optional<Duration> TransferBounds::arrival(Rank device, std::size_t transfer) const {
  const Item& own = items_[item_of_[device][transfer]];
  const auto before = wait(own);
  return before ? std::optional<Duration>(*before + own.bit + own.pure + own.look) : std::nullopt;
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
