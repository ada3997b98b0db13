// Turns the transfers of several chips into one SPI bus's exchanges: by priority and with deadlines.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/bus_counters.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/slot_state.hpp"
#include "finemote/standstill.hpp"
#include "finemote/time.hpp"

namespace finemote {

class SpiBus;

/// One chip select on an SPI bus: at most one transfer at a time. As I2cSlot; an SPI chip cannot refuse, so a missing
/// one shows only in what it sends.
class SpiSlot {
 public:
  /// @param bus       whose table names the slot
  /// @param select    chip select of the port, in the order of the board file
  /// @param priority  0 is the most urgent: the index of the bucket, shortest period first
  /// @param mode      0..3: CPOL * 2 + CPHA
  constexpr SpiSlot(SpiBus& bus, std::uint8_t select, std::uint8_t priority, std::uint8_t mode = 3)
      : bus_(&bus), select_(select), priority_(priority), mode_(mode) {}

  /// Asks for an exchange of `size` >= 1 bytes, both ways at once. False, and nothing is changed, while busy().
  /// `write` null sends 0xFF, `read` null drops what comes; the bytes stay with the device and must not change while
  /// busy(). Context: the device's bucket.
  bool start(const std::uint8_t* write, std::uint8_t* read, std::size_t size);

  /// What became of the last exchange. Context: any.
  [[nodiscard]] SlotState state() const { return state_.load(); }
  /// An exchange waits or is on the wire. Context: any.
  [[nodiscard]] bool busy() const { return is_under_way(state()); }
  /// The last exchange ended well. True until the next start(). Context: any.
  [[nodiscard]] bool done() const { return state() == SlotState::kDone; }
  /// When the last exchange ended. Only while !busy() and not in kIdle. Context: the device's bucket.
  [[nodiscard]] Time ended() const { return ended_; }
  [[nodiscard]] std::uint8_t priority() const { return priority_; }  ///< 0 is the most urgent

 private:
  friend class SpiBus;

  SpiBus* const bus_;
  const std::uint8_t* write_ = nullptr;
  std::uint8_t* read_ = nullptr;
  std::uint16_t size_ = 0;
  const std::uint8_t select_, priority_, mode_;
  Time ended_ = 0;
  Shared<SlotState> state_{SlotState::kIdle};
};

/// One SPI bus; its queue works as that of I2cBus.
class SpiBus {
 public:
  /// @param port      the board's
  /// @param clock_hz  bus clock [Hz]; the port takes the highest that is not above it
  /// @param slots     every slot of this bus, most urgent first
  template <std::size_t N>
  constexpr SpiBus(SpiPort& port, std::int64_t clock_hz, SpiSlot* const (&slots)[N])
      : port_(&port), slots_(slots), count_(N), clock_hz_(clock_hz), byte_time_(8 * 1000000000LL / clock_hz) {}
  /// A bus without devices.
  constexpr SpiBus(SpiPort& port, std::int64_t clock_hz)
      : port_(&port), slots_(nullptr), count_(0), clock_hz_(clock_hz), byte_time_(8 * 1000000000LL / clock_hz) {}

  /// Sets the port up. Context: init.
  void start();
  /// Ends an overdue exchange. Context: fastest bucket.
  void supervise();
  /// An interrupt of the port, or a pended one. Context: interrupt.
  void on_interrupt(SpiEvent event);

  /// No transfer is on the wire, and none begins by itself. Context: init, when no bucket runs.
  [[nodiscard]] bool quiet() const { return unit_.load() % 2 == 0; }
  /// What the bus has done and suffered. Context: any.
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  friend class SpiSlot;
  void request() { port_->pend(); }
  void pick();
  void finish(SlotState result);

  SpiPort* const port_;
  SpiSlot* const* const slots_;
  const std::uint8_t count_;
  const std::int64_t clock_hz_;
  const Duration byte_time_;
  SpiSlot* active_ = nullptr;
  Time deadline_ = 0;
  Shared<std::uint32_t> unit_{0};  ///< as I2cBus
  Shared<std::uint32_t> overdue_{0};
  Standstill standstill_;
  BusCounters counters_;
};

}  // namespace finemote
