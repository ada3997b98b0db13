// Turns the transfers of several devices into one I2C bus's exchanges: by priority, with deadlines, and with recovery.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/bus_counters.hpp"
#include "finemote/mark.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/slot_state.hpp"
#include "finemote/time.hpp"

namespace finemote {

class I2cBus;

/// The way through a TCA9548A to a device: which channels to connect before its transfer. `MuxRoute{}`: no mux.
struct MuxRoute {
  std::uint8_t address = 0;   ///< of the mux, 7 bit; 0: none
  std::uint8_t channels = 0;  ///< its control byte: bit n connects channel n (TCA9548A datasheet SCPS207, 8.6.2)

  /// The same channels of the same mux.
  friend constexpr bool operator==(const MuxRoute& a, const MuxRoute& b) {
    return a.address == b.address && a.channels == b.channels;
  }
};

/// One device's place on an I2C bus: at most one transfer at a time, mux selection and transfer being one unit.
///
/// The bytes stay with the device and must not change while busy(). All members are called by the owning device in its
/// bucket, if not said otherwise.
class I2cSlot {
 public:
  /// @param bus       whose table names the slot
  /// @param address   of the device, 7 bit
  /// @param route     how to reach it
  /// @param priority  0 is the most urgent: the index of the bucket, shortest period first; the bus's table is sorted
  /// by it
  constexpr I2cSlot(I2cBus& bus, std::uint8_t address, MuxRoute route, std::uint8_t priority)
      : bus_(&bus), address_(address), priority_(priority), route_(route) {}

  /// Asks for a transfer: `write_size` bytes out, then, after a repeated START, `read_size` bytes in; either may be 0.
  /// Then, in the same unit, a second exchange of `then_size` bytes out, if not 0.
  /// False, and nothing is changed, while busy(). While the bus is being recovered it returns true and fails at once.
  bool start(const std::uint8_t* write, std::size_t write_size, std::uint8_t* read, std::size_t read_size,
             const std::uint8_t* then = nullptr, std::size_t then_size = 0);
  /// The same of bytes that only go out: what a handle() sends is its command.
  bool start(const std::uint8_t* write, std::size_t write_size) {
    mark_hand_over();
    return start(write, write_size, nullptr, 0);
  }

  /// What became of the last transfer. Context: any.
  [[nodiscard]] SlotState state() const { return state_.load(); }
  /// A transfer waits or is on the wire: its bytes belong to the bus. Context: any.
  [[nodiscard]] bool busy() const { return is_under_way(state()); }
  /// The last transfer ended well. True until the next start(). Context: any.
  [[nodiscard]] bool done() const { return state() == SlotState::kDone; }

  /// When the last transfer ended: STOP or failure. Only while !busy() and not in kIdle.
  [[nodiscard]] Time ended() const { return ended_; }

  /// True after kUnreachableAfter transfers in a row have failed, until one ends well. Context: any.
  [[nodiscard]] bool unreachable() const { return failures_.load() >= kUnreachableAfter; }

  /// The write that makes this device's outputs safe. From now on it is what the bus sends first after every recovery,
  /// before any other transfer, and again and again once the robot has stopped. The bytes are read when it is sent;
  /// size 0 takes it back.
  void set_safe(const std::uint8_t* write, std::size_t size);

  /// The safe write is on the wire: its bytes belong to the bus. Context: any.
  [[nodiscard]] bool sends_safe() const;

  /// Times the safe write has been sent and acknowledged; wraps. Context: any.
  [[nodiscard]] std::uint32_t safe_writes() const { return safe_writes_.load(); }

  [[nodiscard]] std::uint8_t address() const { return address_; }    ///< of the device, 7 bit
  [[nodiscard]] std::uint8_t priority() const { return priority_; }  ///< 0 is the most urgent
  [[nodiscard]] const MuxRoute& route() const { return route_; }     ///< the way to the device
  [[nodiscard]] I2cBus& bus() const { return *bus_; }                ///< the bus that carries its transfers

 private:
  friend class I2cBus;
  void end(SlotState result, Time at);
  void count_failure(bool failed);

  I2cBus* const bus_;
  const std::uint8_t* write_ = nullptr;
  std::uint8_t* read_ = nullptr;
  const std::uint8_t* then_ = nullptr;
  const std::uint8_t* safe_ = nullptr;
  std::uint16_t write_size_ = 0, read_size_ = 0, then_size_ = 0;
  Shared<std::uint16_t> safe_size_{0};
  const std::uint8_t address_, priority_;
  const MuxRoute route_;
  Time ended_ = 0;
  Shared<SlotState> state_{SlotState::kIdle};
  Shared<std::uint8_t> failures_{0};  ///< in a row, saturating
  Shared<std::uint32_t> safe_writes_{0};
};

/// One I2C bus: a queue without a lock.
///
/// Whoever asks for a transfer only marks its slot and pends the bus's interrupt. The interrupt alone begins and ends
/// transfers; when the bus is free it takes the first queued slot of the table. So no bucket ever waits or masks
/// anything, and the order on the wire is the one the analysis assumes: by priority, not preemptive.
class I2cBus {
 public:
  /// @param port      the board's
  /// @param clock_hz  bus clock, 10 kHz..1 MHz
  /// @param slots     every slot of this bus, most urgent first; also behind muxes
  template <std::size_t N>
  constexpr I2cBus(I2cPort& port, std::int64_t clock_hz, I2cSlot* const (&slots)[N])
      : I2cBus(port, clock_hz, slots, N) {}
  /// A bus without devices.
  constexpr I2cBus(I2cPort& port, std::int64_t clock_hz) : I2cBus(port, clock_hz, nullptr, 0) {}

  /// Sets the port up, and frees lines that a part holds, which takes 240 us at most. Nothing is known of the muxes.
  /// Context: init.
  void start();

  /// Ends an overdue transfer and carries recovery on, at most one port step per call. Context: fastest bucket, once
  /// per period.
  void supervise();

  /// An interrupt of the port, or a pended one. Context: interrupt.
  void on_interrupt(I2cEvent event);

  /// True while the bus works; false from a bus error or an overdue transfer to the end of its recovery. Context: any.
  [[nodiscard]] bool ready() const { return mode_.load() == Mode::kReady; }

  /// No transfer is on the wire, and none begins by itself. Context: init, when no bucket runs.
  [[nodiscard]] bool quiet() const { return unit_.load() % 2 == 0; }
  /// What the bus has done and suffered. Context: any.
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  friend class I2cSlot;

  enum class Mode : std::uint8_t { kOff, kReady, kRecover, kStuck };
  enum class Phase : std::uint8_t { kDeselect, kSelect, kTransfer, kThen };

  constexpr I2cBus(I2cPort& port, std::int64_t clock_hz, I2cSlot* const* slots, std::size_t count)
      : port_(&port),
        slots_(slots),
        count_(static_cast<std::uint8_t>(count)),
        clock_hz_(static_cast<std::int32_t>(clock_hz)),
        byte_time_(static_cast<std::int32_t>(9 * 1000000000LL / clock_hz)),
        safe_cursor_(count_) {}

  void request() { port_->pend(); }
  void pick(Time at);
  void begin_unit(I2cSlot& slot, bool safe, Time at);
  [[nodiscard]] std::int32_t most_bytes(const I2cSlot& slot) const;
  void begin_phase(Phase phase);
  I2cMessage message(std::uint8_t mux);
  std::uint8_t next_to_switch_off();
  void go_on();
  Time finish_unit(SlotState result);
  void free_lines();
  void enter_recovery();
  void begin_recovery();
  void look_at_unit();
  void send_safe();
  void carry_recovery_on();

  I2cPort* const port_;
  I2cSlot* const* const slots_;
  const std::uint8_t count_;
  const std::int32_t clock_hz_;
  const std::int32_t byte_time_;  ///< ns, wire time of a byte and its acknowledge, rounded down

  I2cSlot* active_ = nullptr;  ///< only the interrupt writes what follows, while the mode is kReady
  Phase phase_ = Phase::kTransfer;
  bool safe_unit_ = false;    ///< the active unit is the slot's safe write
  std::uint8_t safe_cursor_;  ///< slots whose safe write has still to be sent begin here
  std::uint8_t deselect_cursor_ = 0;
  std::uint32_t switched_off_[4] = {};  ///< addresses of muxes, a bit each, that this unit switched off already
  bool mux_known_ = false;              ///< no mux but selected_ connects anything
  MuxRoute selected_{};                 ///< the mux channels connected now
  std::uint8_t mux_byte_ = 0;
  Time begun_ = 0;                    ///< when the unit on the wire did
  std::int32_t unit_bytes_ = 0;       ///< that it takes at most
  Shared<std::uint32_t> unit_{0};     ///< begins and ends of units: odd while one is on the wire
  Shared<std::uint32_t> overdue_{0};  ///< the unit supervise() wants ended
  Shared<Mode> mode_{Mode::kOff};
  bool is_stopped_ = false;         ///< what was queued by then has failed
  std::uint8_t recovery_step_ = 0;  ///< only supervise() writes it
  std::uint8_t retry_wait_ = 0;     ///< calls of supervise() until a stuck bus is tried again
  BusCounters counters_;
};

}  // namespace finemote
