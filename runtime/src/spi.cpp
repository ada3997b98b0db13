#include "finemote/spi.hpp"

#include "finemote/fault.hpp"
#include "finemote/mark.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "start.hpp"

namespace finemote {

namespace {

/// Of module spi.
enum SpiFault : std::uint8_t { kTransferError = 1, kOverdue };

constexpr Duration kDeadlineSlack = 300 * kMicrosecond;
/// Where there is no DMA every byte waits for an interrupt, and those of other buses come in between.
constexpr Duration kByteSlack = 3 * kMicrosecond;

}  // namespace

bool SpiSlot::start(const std::uint8_t* write, std::uint8_t* read, std::size_t size) {
  if (busy() || size == 0) return false;
  write_ = write;
  read_ = read;
  size_ = static_cast<std::uint16_t>(size);
  state_.store(SlotState::kQueued);
  bus_->request();
  return true;
}

void SpiBus::start() {
  list_bus(counters_);
  port_->configure(clock_hz_, *this);
}

void SpiBus::on_interrupt(SpiEvent event) {
  if (active_ != nullptr) {
    if (event == SpiEvent::kNone) {
      if (overdue_.load() != unit_.load()) return;
      port_->abort();
      ++counters_.overdue;
      count_fault(Module::spi, kOverdue);
    }
    if (event == SpiEvent::kError) count_fault(Module::spi, kTransferError);
    finish(event == SpiEvent::kDone ? SlotState::kDone : SlotState::kFailed);
  }
  pick();
}

void SpiBus::pick() {
  only_if_raised_by<Raised::request, Raised::end>();  // steps come while a unit is under way
  for (std::uint8_t i = 0; i < count_; ++i) {
    SpiSlot& slot = *slots_[i];
    if (slot.state() != SlotState::kQueued) continue;
    active_ = &slot;
    slot.state_.store(SlotState::kActive);
    deadline_ = now() + 2 * slot.size_ * (byte_time_ + kByteSlack) + kDeadlineSlack;
    unit_.store(unit_.load() + 1);
    port_->begin({slot.select_, slot.mode_, slot.write_, slot.read_, slot.size_});
    return;
  }
}

void SpiBus::finish(SlotState result) {
  only_if_raised_by<Raised::end>();
  ++counters_.transfers;
  if (result != SlotState::kDone) ++counters_.errors;
  unit_.store(unit_.load() + 1);
  active_->ended_ = now();
  active_->state_.store(result);
  active_ = nullptr;
}

void SpiBus::supervise() {
  const MarkedWork<Work::supervise_spi> marked;
  if (detail::has_stopped()) {  // it may have cut off whoever had queued something, and not asked for it
    only_after_fault();
    port_->pend();
  }
  const std::uint32_t unit = unit_.load();
  const std::uint16_t moved = port_->moved();
  const Time deadline = deadline_;
  const Time at = now();
  Shared<std::uint32_t>::fence();
  if (unit % 2 == 0 || unit_.load() != unit || port_->moved() != moved) return;
  const Duration still = standstill_.lasts(unit << 16U | moved, at);
  if (at <= deadline || still <= 2 * byte_time_) return;
  overdue_.store(unit);
  port_->pend();
}

}  // namespace finemote
