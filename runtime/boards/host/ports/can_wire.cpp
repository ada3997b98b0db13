#include "runtime/boards/host/ports/can_wire.hpp"

#include <algorithm>

#include "finemote/can.hpp"
#include "finemote/host.hpp"

namespace finemote {

namespace {

/// Longest form of a standard data frame with stuff bits, and three bits between frames (ISO 11898-1).
Duration wire_time(const CanHardware& wire, const CanFrame& frame) {
  const int bits = 47 + 8 * frame.size + (34 + 8 * frame.size - 1) / 4;
  return bits * kSecond / wire.bitrate;
}

// The identifier decides among the mailboxes; an equal one is sent in order.
void send_next(CanHardware& wire) {
  if (wire.sending || wire.off || wire.mailboxes.empty()) return;
  const auto next = std::min_element(wire.mailboxes.begin(), wire.mailboxes.end(),
                                     [](const CanFrame& a, const CanFrame& b) { return a.id < b.id; });
  const CanFrame frame = *next;
  wire.sending = true;
  host::interrupt_at(now() + wire_time(wire, frame), [&wire, frame] {
    wire.sending = false;
    if (wire.off) return wire.bus->on_interrupt();
    const auto same =
        std::find_if(wire.mailboxes.begin(), wire.mailboxes.end(), [&](const CanFrame& f) { return f.id == frame.id; });
    if (same != wire.mailboxes.end()) wire.mailboxes.erase(same);
    wire.sent.push_back({now(), frame});
    if (wire.listener) wire.listener(frame);
    wire.bus->on_interrupt();
    send_next(wire);
  });
}

}  // namespace

void CanHardware::feed(Time at, const CanFrame& frame) {
  host::interrupt_at(at, [this, frame] {
    const bool is_accepted =
        std::any_of(accepted.begin(), accepted.end(), [&](const CanIds& ids) { return ids.hold(frame.id); });
    if (off || !is_accepted) return;
    bus->on_frame(frame, {now(), now()});
  });
}

void CanPort::configure(std::int64_t bitrate, CanBus& bus) {
  hardware_->bitrate = bitrate;
  hardware_->bus = &bus;
  hardware_->accepted.clear();
  bus.each_ids([this](const CanIds& ids) { hardware_->accepted.push_back(ids); });
}

void CanPort::pend() {
  if (hardware_->when_pended) hardware_->when_pended();
  host::interrupt_at(now(), [wire = hardware_] { wire->bus->on_interrupt(); });
}

bool CanPort::send(const CanFrame& frame) {
  if (hardware_->mailboxes.size() >= CanPort::kMailboxes) return false;
  hardware_->mailboxes.push_back(frame);
  send_next(*hardware_);
  return true;
}

void CanPort::tell_when_sent() {}  // every frame's end tells

unsigned CanPort::unsent() const { return static_cast<unsigned>(hardware_->mailboxes.size()); }

bool CanPort::idle(std::int64_t) const { return true; }
void CanPort::abort() { hardware_->mailboxes.clear(); }
bool CanPort::bus_off() const { return hardware_->off; }
bool CanPort::recover() {
  hardware_->off = false;
  return true;
}
std::uint16_t CanPort::error_counters() const { return hardware_->off ? 0x00FF : 0; }

}  // namespace finemote
