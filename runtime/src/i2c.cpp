#include "finemote/i2c.hpp"

#include "finemote/fault.hpp"
#include "finemote/mark.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "start.hpp"

namespace finemote {

namespace {

/// Of module i2c.
enum I2cFault : std::uint8_t { kBusError = 1, kOverdue, kStuckBus };

constexpr std::uint8_t kNoChannels = 0;

/// Slack of a deadline beyond twice the wire time: start-up of the unit and interrupts of the same priority.
constexpr Duration kDeadlineSlack = 300 * kMicrosecond;

/// Calls of supervise() between two attempts on a bus that stays stuck.
constexpr std::uint8_t kRetryAfter = 20;

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- slot

bool I2cSlot::start(const std::uint8_t* write, std::size_t write_size, std::uint8_t* read, std::size_t read_size,
                    const std::uint8_t* then, std::size_t then_size) {
  if (busy()) return false;
  write_ = write;
  write_size_ = static_cast<std::uint16_t>(write_size);
  read_ = read;
  read_size_ = static_cast<std::uint16_t>(read_size);
  then_ = then;
  then_size_ = static_cast<std::uint16_t>(then_size);
  state_.store(SlotState::kQueued);
  // Recovery fails what is queued when it begins; a request made during it fails here, so that no output computed
  // before or during the trouble is sent after the safe writes.
  if (!bus_->ready() && state_.replace(SlotState::kQueued, SlotState::kFailed)) {
    end(SlotState::kFailed, now());
    return true;
  }
  bus_->request();
  return true;
}

void I2cSlot::set_safe(const std::uint8_t* write, std::size_t size) {
  safe_ = write;
  safe_size_.store(static_cast<std::uint16_t>(size));
}

bool I2cSlot::sends_safe() const { return bus_->unit_.load() % 2 != 0 && bus_->safe_unit_ && bus_->active_ == this; }

void I2cSlot::end(SlotState result, Time at) {
  count_failure(result != SlotState::kDone);
  ended_ = at;
  state_.store(result);
}

void I2cSlot::count_failure(bool failed) { failures_.store(failures_after(failures_.load(), failed)); }

// ----------------------------------------------------------------------------------------------------------------- bus

void I2cBus::start() {
  list_bus(counters_);
  mode_.store(Mode::kReady);
  port_->configure(clock_hz_, *this);
  if (!port_->lines_free()) free_lines();
}

/// A reset cut off a read, whose part still holds the data line: the safe writes must not wait for a deadline.
void I2cBus::free_lines() {
  begin_recovery();
  while (mode_.load() == Mode::kRecover) carry_recovery_on();  // kMaxRecoverySteps at most
}

void I2cBus::on_interrupt(I2cEvent event) {
  if (mode_.load() != Mode::kReady) return;
  if (active_ == nullptr) return pick(now());
  switch (event) {
    case I2cEvent::kNone:
      if (overdue_.load() != unit_.load()) return;
      ++counters_.overdue;
      count_fault(Module::i2c, kOverdue);
      return enter_recovery();
    case I2cEvent::kError:
      count_fault(Module::i2c, kBusError);
      return enter_recovery();
    case I2cEvent::kNack:
      only_after_fault();
      if (phase_ == Phase::kDeselect) return go_on();  // a mux that does not answer connects nothing
      return pick(finish_unit(SlotState::kNack));
    case I2cEvent::kDone:
      return go_on();
  }
}

/// The next phase of the unit or, behind its last one, the next unit.
void I2cBus::go_on() {
  only_if_raised_by<Raised::end>();
  switch (phase_) {
    case Phase::kDeselect:
      return begin_phase(Phase::kDeselect);
    case Phase::kSelect:
      selected_ = active_->route_;
      mux_known_ = true;
      return begin_phase(Phase::kTransfer);
    case Phase::kTransfer:
      if (!safe_unit_ && active_->then_size_ != 0) return begin_phase(Phase::kThen);
      break;
    case Phase::kThen:
      break;
  }
  pick(finish_unit(SlotState::kDone));
}

void I2cBus::pick(Time at) {
  only_if_raised_by<Raised::request, Raised::end>();  // steps come while a unit is under way
  for (std::uint8_t i = safe_cursor_; i < count_; ++i) {
    only_after_fault();
    if (slots_[i]->safe_size_.load() == 0) continue;
    safe_cursor_ = static_cast<std::uint8_t>(i + 1);
    return begin_unit(*slots_[i], true, at);
  }
  safe_cursor_ = count_;
  for (std::uint8_t i = 0; i < count_; ++i) {
    if (slots_[i]->state_.load() == SlotState::kQueued) return begin_unit(*slots_[i], false, at);
  }
}

void I2cBus::begin_unit(I2cSlot& slot, bool safe, Time at) {
  active_ = &slot;
  safe_unit_ = safe;
  if (!safe) slot.state_.store(SlotState::kActive);
  begun_ = at;
  unit_bytes_ = most_bytes(slot);
  unit_.store(unit_.load() + 1);
  const bool connected = slot.route_.address == 0 || (mux_known_ && selected_ == slot.route_);
  deselect_cursor_ = 0;
  for (std::uint32_t& addresses : switched_off_) addresses = 0;
  begin_phase(connected ? Phase::kTransfer : Phase::kDeselect);
}

/// Of the longest form of the unit: every slot's mux switched off, two address bytes per exchange, and one byte's time
/// for STARTs and STOPs.
std::int32_t I2cBus::most_bytes(const I2cSlot& slot) const {
  const int muxes = slot.route_.address == 0 ? 0 : count_ + 1;
  const int bytes = safe_unit_ ? 1 + slot.safe_size_.load() : 4 + slot.write_size_ + slot.read_size_ + slot.then_size_;
  return 3 * muxes + bytes + 1;
}

void I2cBus::begin_phase(Phase phase) {
  const std::uint8_t mux = phase == Phase::kDeselect ? next_to_switch_off() : 0;
  phase_ = phase == Phase::kDeselect && mux == 0 ? Phase::kSelect : phase;
  port_->begin(message(mux));
}

/// What the phase sends and reads.
/// @param mux  the one that is switched off
I2cMessage I2cBus::message(std::uint8_t mux) {
  const I2cSlot& slot = *active_;
  switch (phase_) {
    case Phase::kDeselect:
      return {mux, &kNoChannels, 1, nullptr, 0};
    case Phase::kSelect:
      mux_known_ = false;
      mux_byte_ = slot.route_.channels;
      return {slot.route_.address, &mux_byte_, 1, nullptr, 0};
    case Phase::kTransfer:
      if (safe_unit_) {
        only_after_fault();
        return {slot.address_, slot.safe_, slot.safe_size_.load(), nullptr, 0};
      }
      return {slot.address_, slot.write_, slot.write_size_, slot.read_, slot.read_size_};
    case Phase::kThen:
      break;
  }
  return {slot.address_, slot.then_, slot.then_size_, nullptr, 0};
}

/// Address of the next other mux that may connect something; 0 when there is none left. What muxes connect is unknown
/// until the first of them is set, which is part of the bring-up, and after a fault.
std::uint8_t I2cBus::next_to_switch_off() {
  const std::uint8_t target = active_->route_.address;
  if (mux_known_) {
    const bool is_off = deselect_cursor_ != 0 || selected_.address == target;
    deselect_cursor_ = 1;
    return is_off ? std::uint8_t{0} : selected_.address;
  }
  for (std::uint8_t i = deselect_cursor_; i < count_; ++i) {
    only_after_fault();
    const std::uint8_t mux = slots_[i]->route_.address;
    if (mux == 0 || mux == target) continue;
    std::uint32_t& addresses = switched_off_[mux / 32 % 4];
    const std::uint32_t own = std::uint32_t{1} << mux % 32;
    if ((addresses & own) != 0) continue;
    addresses |= own;
    deselect_cursor_ = static_cast<std::uint8_t>(i + 1);
    return mux;
  }
  deselect_cursor_ = count_;
  return 0;
}

Time I2cBus::finish_unit(SlotState result) {
  const Time at = now();
  I2cSlot& slot = *active_;
  active_ = nullptr;
  unit_.store(unit_.load() + 1);
  ++counters_.transfers;
  if (result != SlotState::kDone) ++counters_.errors;
  // A mux that lost its setting, as after a drop of its supply, shows as a device that does not answer: set it anew.
  if (result != SlotState::kDone && slot.route_.address != 0) mux_known_ = false;
  if (!safe_unit_) {
    slot.end(result, at);
    return at;
  }
  only_after_fault();
  slot.count_failure(result != SlotState::kDone);
  if (result == SlotState::kDone) slot.safe_writes_.store(slot.safe_writes_.load() + 1);
  return at;
}

// ------------------------------------------------------------------------------------------------------------ recovery

void I2cBus::enter_recovery() {
  port_->abort();
  begin_recovery();
  const Time at = finish_unit(SlotState::kFailed);
  for (std::uint8_t i = 0; i < count_; ++i) {
    if (slots_[i]->state() == SlotState::kQueued) slots_[i]->end(SlotState::kFailed, at);
  }
  mux_known_ = false;
}

void I2cBus::begin_recovery() {
  mode_.store(Mode::kRecover);
  ++counters_.recoveries;
  recovery_step_ = 0;
}

void I2cBus::supervise() {
  const MarkedWork<Work::supervise_i2c> marked;
  switch (mode_.load()) {
    case Mode::kOff:
      return;
    case Mode::kReady:
      if (detail::has_stopped()) send_safe();
      return look_at_unit();
    case Mode::kRecover:
      return carry_recovery_on();
    case Mode::kStuck:
      only_after_fault();
      if (retry_wait_ > 1) {  // a stop may have cut off what comes after the last one
        --retry_wait_;
        return;
      }
      recovery_step_ = 0;
      mode_.store(Mode::kRecover);
      return;
  }
}

/// No bucket runs any more. What they had asked for fails, and every safe write goes out, again with each call.
void I2cBus::send_safe() {
  only_after_fault();
  for (std::uint8_t i = 0; i < count_ && !is_stopped_; ++i) {
    if (slots_[i]->state_.replace(SlotState::kQueued, SlotState::kFailed)) slots_[i]->end(SlotState::kFailed, now());
  }
  is_stopped_ = true;
  if (unit_.load() % 2 != 0) return;  // its routine has the cursor
  safe_cursor_ = 0;
  port_->pend();
}

/// A unit is overdue that stands still behind its deadline: one that goes on may have been kept waiting by interrupts.
void I2cBus::look_at_unit() {
  const std::uint32_t unit = unit_.load();
  const Time deadline = begun_ + 2 * unit_bytes_ * Duration{byte_time_} + kDeadlineSlack;
  Shared<std::uint32_t>::fence();
  if (unit % 2 == 0 || unit_.load() != unit || now() <= deadline) return;
  // An odd number that has not changed: what was read is this unit's, and whole.
  if (!port_->stands_still() || unit_.load() != unit) return;
  overdue_.store(unit);
  port_->pend();
}

void I2cBus::carry_recovery_on() {
  only_after_fault();
  const I2cPort::Recovery result = port_->recover(recovery_step_++);
  if (result == I2cPort::Recovery::kFree) {
    safe_cursor_ = 0;
    mode_.store(Mode::kReady);
    port_->pend();
  } else if (result == I2cPort::Recovery::kStuck || recovery_step_ >= I2cPort::kMaxRecoverySteps) {
    count_fault(Module::i2c, kStuckBus);
    retry_wait_ = kRetryAfter;
    mode_.store(Mode::kStuck);
  }
}

}  // namespace finemote
