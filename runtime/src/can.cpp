#include "finemote/can.hpp"

#include "finemote/fault.hpp"

namespace finemote {

namespace {

/// Of module can.
enum CanFault : std::uint8_t { kBusOff = 1, kNoGroup };

/// The count of errors above which a controller is passive: ISO 11898-1.
constexpr std::uint8_t kErrorPassive = 127;

/// 128 sequences of eleven recessive bits: ISO 11898-1.
constexpr std::int64_t kRecoveryBits = 128 * 11;

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- slot

CanSlot::Received CanSlot::received() const {
  Received copy;
  // The count is raised before and after a frame is stored: odd while it is. Frames of one identifier are at least
  // 47 bits apart, so that a copy is disturbed at most once.
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::uint32_t before = changes_.load();
    copy.frame = in_;
    copy.at = at_;
    Shared<std::uint32_t>::fence();
    copy.count = before / 2;
    if (before % 2 == 0 && changes_.load() == before) return copy;
  }
  return {};
}

bool CanSlot::send(const CanFrame& frame) {
  if (waiting_.load()) return false;
  out_ = frame;
  waiting_.store(true);
  bus_->request();
  return true;
}

// ----------------------------------------------------------------------------------------------------------------- bus

void CanBus::start() {
  list_bus(counters_);
  std::uint16_t ids[kMaxSlots];
  for (std::uint8_t i = 0; i < count_; ++i) ids[i] = slots_[i]->receives_;
  port_->configure(bitrate_, *this, ids, count_);
}

void CanBus::on_frame(const CanFrame& frame, Time at) {
  ++counters_.transfers;
  for (std::uint8_t i = 0; i < count_; ++i) {
    CanSlot& slot = *slots_[i];
    if (slot.receives_ != frame.id) continue;
    slot.changes_.store(slot.changes_.load() + 1);
    slot.in_ = frame;
    slot.at_ = at;
    slot.changes_.store(slot.changes_.load() + 1);
    return;
  }
  ++counters_.lost;  // a filter lets more through than is wanted
}

// Groups first: they carry the actuators. Whatever finds no mailbox is sent from the interrupt that frees one.
void CanBus::on_interrupt() {
  for (Group& group : groups_) {
    if (group.waiting.load() && !send_group(group)) return;
  }
  for (std::uint8_t i = 0; i < count_; ++i) {
    CanSlot& slot = *slots_[i];
    if (!slot.waiting_.load()) continue;
    if (!port_->send(slot.out_)) return;
    slot.waiting_.store(false);
    ++counters_.transfers;
  }
}

bool CanBus::send_group(Group& group) {
  CanFrame frame;
  frame.id = group.id.load();
  frame.size = 8;
  group.waiting.store(false);
  for (int i = 0; i < 4; ++i) {
    const std::uint16_t word = group.words[i].load();
    frame.data[2 * i] = static_cast<std::uint8_t>(word >> 8);
    frame.data[2 * i + 1] = static_cast<std::uint8_t>(word & 0xFF);
  }
  if (!port_->send(frame)) {
    group.waiting.store(true);
    return false;
  }
  ++counters_.transfers;
  return true;
}

bool CanBus::set_group(std::uint16_t id, unsigned index, std::int16_t value) {
  for (Group& group : groups_) {
    if (group.id.load() == 0) group.id.replace(0, id);  // whoever comes second sees the first's identifier
    if (group.id.load() != id) continue;
    group.words[index & 3].store(static_cast<std::uint16_t>(value));
    group.changed.store(true);
    return true;
  }
  count_fault(Module::can, kNoGroup);
  return false;
}

void CanBus::flush() {
  bool any = false;
  for (Group& group : groups_) {
    if (!group.changed.exchange(false)) continue;
    group.waiting.store(true);
    any = true;
  }
  if (any) port_->pend();
}

// What was queued before the bus was lost is old: all groups go to zero, and only new commands drive again. A bus that
// is found off when the recovery must long be over was lost once more in between: the recovery begins anew.
void CanBus::supervise() {
  if (!port_->bus_off()) {
    recovering_ = false;
    // Error passive: nobody acknowledges, and what waits in the mailboxes grows old, for ever on an empty bus. It goes;
    // the next flush sends what holds then.
    if (transmit_errors() > kErrorPassive) port_->abort();
    return;
  }
  const Time at = now();
  if (recovering_ && at < try_again_) return;
  recovering_ = true;
  try_again_ = at + 2 * (kRecoveryBits * kSecond / bitrate_);
  ++counters_.recoveries;
  ++counters_.errors;
  count_fault(Module::can, kBusOff);
  for (Group& group : groups_) {
    for (auto& word : group.words) word.store(0);
    group.waiting.store(group.id.load() != 0);
  }
  for (std::uint8_t i = 0; i < count_; ++i) slots_[i]->waiting_.store(false);
  port_->abort();
  port_->recover();
  port_->pend();
}

}  // namespace finemote
