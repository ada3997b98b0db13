#include "finemote/can.hpp"

#include "finemote/fault.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/mark.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "start.hpp"

namespace finemote {

namespace {

/// Of module can.
enum CanFault : std::uint8_t { kBusOff = 1, kNoGroup };

/// Above what the routine takes that puts frames into mailboxes.
constexpr Duration kLongestRoutine = 20 * kMicrosecond;

constexpr std::uint32_t bit_of(unsigned number) { return std::uint32_t{1} << number % 32; }

/// Of the lowest bit that is set; `bits` is not 0.
unsigned lowest(std::uint32_t bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

/// Sequences of eleven recessive bits before a controller is back on the bus: ISO 11898-1. Where others send all the
/// time each frame ends with one.
constexpr std::int64_t kRecoveryPauses = 128;

/// How long the controller may take until it begins with that; ST's drivers allow as much.
constexpr Duration kLongestPreparation = 10 * kMillisecond;

}  // namespace

// --------------------------------------------------------------------------------------------------------------- inbox

CanInbox::Received CanInbox::received() const {
  Received copy;
  // The count is raised before and after a frame is stored: odd while it is. Frames of one identifier are at least
  // 47 bits apart, so that a copy is disturbed at most once.
  for (int attempt = 0; attempt < 3; ++attempt) {
    retried_if_interrupted<RetriedBy::received>();
    const std::uint32_t before = changes_.load();
    copy.frame = in_;
    copy.at = at_;
    Shared<std::uint32_t>::fence();
    copy.count = before / 2;
    if (before % 2 == 0 && changes_.load() == before) return copy;
  }
  return {};
}

void CanInbox::store(const CanFrame& frame, Time at) {
  changes_.store(changes_.load() + 1);
  in_ = frame;
  at_ = at;
  changes_.store(changes_.load() + 1);
}

// ---------------------------------------------------------------------------------------------------------------- slot

CanSlot::Received CanSlot::received(unsigned entry) const {
  const CanInbox* inbox = &inbox_;
  for (; entry > 0 && inbox != nullptr; --entry) inbox = inbox->next_;
  return inbox != nullptr ? inbox->received() : Received{};
}

/// The earliest that a frame was made which arrived then, on a bus that had been busy since.
Time CanSlot::made(Time busy_since, Time arrival) const {
  return waits_ == kAnyTime ? busy_since : latest(busy_since, arrival - waits_);
}

bool CanSlot::set_shared(const std::uint8_t* bytes) { return bus_->set_shared(*this, bytes); }

bool CanSlot::send(const CanFrame& frame) {
  mark_hand_over();
  const std::uint32_t own = bit_of(place_);
  if ((bus_->waiting_slots_.load() & own) != 0) return false;
  out_ = frame;
  bus_->waiting_slots_.set_bits(own);
  bus_->request();
  return true;
}

// ----------------------------------------------------------------------------------------------------------------- bus

void CanBus::start() {
  list_bus(counters_);
  assign_places();
  port_->configure(bitrate_, *this);
}

bool CanBus::quiet() {
  was_idle_ = was_idle_ || (port_->unsent() == 0 && port_->idle(bitrate_));
  return was_idle_;
}

void CanBus::on_frame(const CanFrame& frame, Moment arrival) {
  const Time since = busy_since(arrival);
  ++counters_.transfers;
  if (arrival.before_start()) return;
  for (std::uint8_t i = 0; i < count_; ++i) {
    for (CanInbox* inbox = &slots_[i]->inbox_; inbox != nullptr; inbox = inbox->next_) {
      if (inbox->ids_.hold(frame.id)) return inbox->store(frame, slots_[i]->made(since, arrival.earliest));
    }
  }
  ++counters_.lost;  // a filter lets more through than is wanted
}

/// Since when the bus has been busy without a pause when this frame began, as far as frames tell that we send or
/// receive: those that nobody here receives, and damaged ones, are not seen (assumptions 1 and 6 in docs/timing.md).
/// All are taken as long as they can be.
Time CanBus::busy_since(Moment arrival) {
  Time since = arrival.earliest - longest_frame_;
  since = received_.reach(since);
  for (const Busy& sent : sent_) since = sent.reach(since);
  since = received_.reach(since);
  received_ = {since, arrival.latest};
  const unsigned unsent = port_->unsent();  // they may follow at once
  if (unsent > 0) sent_[0].last_to(arrival.latest + static_cast<std::int32_t>(unsent) * longest_frame_);
  return since;
}

/// A frame of another node that waits for the same bit to begin was there up to a bit earlier than ours.
/// @param at  when the routine that sends began
void CanBus::send(const Next& next, Time at) {
  if (!port_->send(*next.frame)) return;
  next.waiting->clear_bits(next.own);
  if (silent_groups_.load() != 0 && next.waiting == &waiting_groups_) {
    only_after_fault();
    silent_groups_.clear_bits(next.own);
  }
  if (at > sent_[0].until) {
    for (unsigned i = kSentKept - 1; i > 0; --i) sent_[i] = sent_[i - 1];
    sent_[0] = {at - longest_frame_ / static_cast<std::int32_t>(kLongestFrameBits), at + kLongestRoutine};
  }
  sent_[0].until += longest_frame_;
  ++counters_.transfers;
}

// What finds no mailbox is sent from the interrupt that frees one. One routine fills all mailboxes at most once, which
// bounds it; only a mailbox that was filled here can have fallen free since. Mailboxes are free whose frames' ends are
// served here, or while nothing waited: then a request has come since.
void CanBus::on_interrupt() {
  const Time at = now();
  for (unsigned left = CanPort::kMailboxes;; --left) {
    const Next next = first_waiting();
    if (next.frame == nullptr) return;
    if (left == 0 || port_->unsent() == CanPort::kMailboxes) return port_->tell_when_sent();
    once_for_each<Raised::end>();
    send(next, at);
  }
}

/// Groups first: they carry the actuators. To one that is being set the flush behind what sets it comes back.
CanBus::Next CanBus::first_waiting() {
  const std::uint32_t groups = waiting_groups_.load() & ~setting_groups_.load();
  if (groups != 0) {
    const unsigned first = lowest(groups);
    Group& group = groups_[first];
    group.frame.id = group.id.load();
    group.frame.size = 8;
    return {&group.frame, &waiting_groups_, bit_of(first)};
  }
  const std::uint32_t slots = waiting_slots_.load();
  if (slots == 0) return {};
  const unsigned first = lowest(slots);
  if (first >= count_) return {};  // none has that place: tools see that what follows is a slot
  return {&slots_[first]->out_, &waiting_slots_, bit_of(first)};
}

/// The first slot whose devices fill the same frame as this one.
std::uint8_t CanBus::first_sharing(std::uint8_t slot) const {
  for (std::uint8_t i = 0; i < slot; ++i) {
    const CanShare& share = slots_[i]->share_;
    if (share.width != 0 && share.frame == slots_[slot]->share_.frame) return i;
  }
  return slot;
}

/// Slots that share a frame share a group.
void CanBus::assign_places() {
  std::uint32_t groups = 0, group_of_place[kMaxSlots];
  for (std::uint8_t i = 0; i < count_; ++i) {
    CanSlot& slot = *slots_[i];
    slot.place_.set(i);
    if (slot.share_.width == 0) continue;
    const std::uint8_t first = first_sharing(i);
    const std::uint32_t group = first < i ? group_of_place[first] : groups++;
    group_of_place[i] = group;
    slot.group_.set(group);
    if (group < kGroups) groups_[group].id.store(slot.share_.frame);
  }
}

/// Of a slot of this bus it is known since the start.
CanBus::Group* CanBus::group_of(const CanSlot& slot) {
  const std::uint32_t index = slot.group_;
  if (index < kGroups) return &groups_[index];
  return slot.share_.width > 0 ? find_group(slot.share_.frame) : nullptr;
}

CanBus::Group* CanBus::find_group(std::uint16_t id) {
  for (Group& group : groups_) {
    if (group.id.load() == 0) group.id.replace(0, id);  // whoever comes second sees the first's identifier
    if (group.id.load() == id) return &group;
  }
  return nullptr;
}

bool CanBus::set_shared(const CanSlot& slot, const std::uint8_t* bytes) {
  mark_hand_over();
  const CanShare& share = slot.share_;
  Group* const group = group_of(slot);
  if (group == nullptr) {
    count_fault(Module::can, kNoGroup);
    return false;
  }
  const std::uint32_t own = bit_of(static_cast<unsigned>(group - groups_));
  setting_groups_.set_bits(own);
  // supervise() may clear the frame in between: what it left of the bytes is written once more.
  for (int attempt = 0; attempt < 2; ++attempt) {
    const std::uint8_t cleared = group->cleared.load();
    write(*group, share, bytes);
    if (group->cleared.load() == cleared) break;
    only_after_fault();
  }
  if ((silent_groups_.load() & own) != 0) {
    only_after_fault();
    for (std::uint8_t& byte : group->frame.data) byte = 0;
  }
  group->priority.store(slot.priority_);
  group->changed.store(true);
  setting_groups_.clear_bits(own);
  return true;
}

void CanBus::write(Group& group, const CanShare& share, const std::uint8_t* bytes) {
  for (std::uint8_t i = 0; i < share.width; ++i) group.frame.data[(share.offset + i) & 7] = bytes[i];
}

void CanBus::flush() {
  flush_if([](const Group&) { return true; });
}

void CanBus::flush(std::uint8_t priority) {
  flush_if([priority](const Group& group) { return group.priority.load() == priority; });
}

template <typename Belongs>
void CanBus::flush_if(Belongs&& belongs) {
  const MarkedWork<Work::flush_can> marked;
  std::uint32_t filled = 0;
  for (unsigned i = 0; i < kGroups; ++i) {
    if (belongs(groups_[i]) && groups_[i].changed.exchange(false)) filled |= bit_of(i);
  }
  if (filled == 0) return;
  waiting_groups_.set_bits(filled);
  port_->pend();
}

// A bus that is found off when the recovery must long be over was lost once more in between: the recovery begins anew.
void CanBus::supervise() {
  const MarkedWork<Work::supervise_can> marked;
  if (!port_->bus_off()) {
    recovering_ = false;
    // Error passive: nobody acknowledges, and what waits in the mailboxes grows old, for ever on an empty bus. It goes;
    // the next flush sends what holds then.
    if (transmit_errors() > kErrorPassive) {
      only_after_fault();
      counters_.errors += port_->unsent();
      port_->abort();
    }
    if (!detail::has_stopped()) return;  // else it may have cut off whoever had something to send, and not asked for it
    only_after_fault();
    return port_->pend();
  }
  only_after_fault();
  const Time at = now();
  if (!recovering_ || at >= try_again_) {
    begin_recovery(at);
  } else if (returning_) {
    silence();  // what jobs have sent meanwhile is old when the bus is back
    return port_->pend();
  }
  returning_ = port_->recover();
  if (!returning_) return;
  try_again_ = at + 2 * kRecoveryPauses * longest_frame_;
  silence();
  port_->pend();
}

void CanBus::begin_recovery(Time at) {
  recovering_ = true;
  try_again_ = at + kLongestPreparation;
  ++counters_.recoveries;
  ++counters_.errors;
  count_fault(Module::can, kBusOff);
}

// What was queued before the controller is back is old: all groups go to zero, and only new commands drive again,
// behind the zeros. The mailboxes are emptied first: the controller may be back at any time, and the zeros must stay in
// them.
void CanBus::silence() {
  waiting_slots_.store(0);
  waiting_groups_.store(0);
  port_->abort();
  std::uint32_t used = 0;
  for (unsigned i = 0; i < kGroups; ++i) {
    if (groups_[i].id.load() != 0) used |= bit_of(i);
  }
  silent_groups_.store(used);
  for (Group& group : groups_) {
    for (std::uint8_t& byte : group.frame.data) byte = 0;
    group.cleared.store(static_cast<std::uint8_t>(group.cleared.load() + 1));
  }
  waiting_groups_.store(used);
}

}  // namespace finemote
