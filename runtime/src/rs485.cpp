#include "finemote/rs485.hpp"

#include "finemote/fault.hpp"
#include "finemote/four_bytes.hpp"
#include "finemote/least.hpp"
#include "finemote/only_after_fault.hpp"
#include "start.hpp"

namespace finemote {

namespace {

/// Of module rs485.
enum Rs485Fault : std::uint8_t { kNoReply = 1, kReceiveHalted };

/// Beyond the wire time of question and answer: how long a part may think.
constexpr Duration kReplySlack = 2 * kMillisecond;

constexpr std::uint32_t bit_of(std::uint32_t place) { return std::uint32_t{1} << place % 32; }

}  // namespace

bool Rs485Slot::start(const std::uint8_t* bytes, std::size_t size, std::size_t reply_size) {
  if (busy() || size == 0 || size > bus_->port_->transmit_capacity() || reply_size > kMaxReply) return false;
  bytes_ = bytes;
  size_ = static_cast<std::uint16_t>(size);
  reply_size_ = static_cast<std::uint16_t>(reply_size);
  state_.store(SlotState::kQueued);
  bus_->waiting_[place_ / 32 % Rs485::kWords].set_bits(bit_of(place_));
  bus_->carry_on();
  return true;
}

SlotState Rs485Slot::state() {
  if (is_under_way(state_.load())) bus_->carry_on();
  return state_.load();
}

void Rs485::start() {
  list_bus(counters_);
  for (std::uint32_t i = 0; i < count_; ++i) slots_[i]->place_.set(i);
  port_->start(baud_, UartFormat::k8N1, ring_);
}

void Rs485::carry_on() {
  if (busy_.exchange(true) && !detail::has_stopped()) return;  // whom we preempt goes on, unless a stop cut it off
  if (active_ != nullptr) take_reply();
  if (active_ == nullptr) pick();
  busy_.store(false);
}

bool Rs485::quiet() {
  carry_on();
  return active_ == nullptr;
}

// The time comes first: where this is preempted for long, what comes meanwhile came in time.
void Rs485::take_reply() {
  const bool is_overdue = now() > deadline_;
  if (port_->transmitting()) {
    if (is_overdue) {
      only_after_fault();
      port_->abort_transmit();
      finish(SlotState::kFailed);
    }
    return;
  }
  Rs485Slot& slot = *active_;
  if (port_->received() - reply_from_ >= slot.reply_size_) {
    const std::size_t size = least(slot.reply_size_, Rs485Slot::kMaxReply);  // which start() has seen to
    for (std::uint32_t i = 0; i < size; ++i) slot.reply_[i] = ring_.bytes[(reply_from_ + i) & (ring_.size - 1)];
    return finish(SlotState::kDone);
  }
  if (!is_overdue) return;
  only_after_fault();
  ++counters_.overdue;
  count_fault(Module::rs485, kNoReply);
  finish(SlotState::kNack);
}

void Rs485::pick() {
  if (port_->receive_halted()) {
    only_after_fault();
    count_fault(Module::rs485, kReceiveHalted);
    ++counters_.recoveries;
    port_->restart_receive();
  }
  if (detail::has_stopped()) {
    only_after_fault();
    look_at_slots();
  }
  for (std::uint32_t word = 0; word < kWords && word * 32 < count_; ++word) {
    const std::uint32_t waiting = waiting_[word].load();
    if (waiting == 0) continue;
    const std::uint32_t place = word * 32 + static_cast<std::uint32_t>(__builtin_ctz(waiting));
    waiting_[word].clear_bits(bit_of(place));
    if (place < count_) ask(*slots_[place]);
    return;
  }
}

/// A stop may have cut off whoever had queued a question and not said so, or had taken it and not asked.
void Rs485::look_at_slots() {
  for (std::uint32_t place = 0; place < count_; ++place) {
    if (slots_[place]->state_.load() == SlotState::kQueued) waiting_[place / 32 % kWords].set_bits(bit_of(place));
  }
}

void Rs485::ask(Rs485Slot& slot) {
  active_ = &slot;
  slot.state_.store(SlotState::kActive);
  const std::size_t size = least(slot.size_, port_->transmit_capacity());  // which start() has seen to
  move_bytes(slot.bytes_, port_->transmit_buffer(), size);
  reply_from_ = port_->received();
  port_->transmit(size);
  deadline_ = now() + 2 * (slot.size_ + slot.reply_size_) * byte_time_ + kReplySlack;  // not before: see take_reply()
}

void Rs485::finish(SlotState result) {
  ++counters_.transfers;
  const bool failed = result != SlotState::kDone;
  if (failed) ++counters_.errors;
  active_->failures_ = failures_after(active_->failures_, failed);
  active_->state_.store(result);
  active_ = nullptr;
}

}  // namespace finemote
