// Turns the requests of several devices into question and answer on one half-duplex RS-485 line.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/at_start.hpp"
#include "finemote/bus_counters.hpp"
#include "finemote/mark.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/slot_state.hpp"
#include "finemote/time.hpp"

namespace finemote {

class Rs485;

/// One device on the line: at most one question at a time.
class Rs485Slot {
 public:
  static constexpr std::size_t kMaxReply = 32;  ///< bytes

  /// @param bus       whose table names the slot
  /// @param id        the device's `id` in the URDF
  /// @param priority  0 is the most urgent: the index of the bucket, shortest period first
  constexpr Rs485Slot(Rs485& bus, std::uint8_t id, std::uint8_t priority) : bus_(&bus), id_(id), priority_(priority) {}

  /// Asks: sends `size` bytes, then takes `reply_size` <= kMaxReply bytes. The bytes must not change while busy().
  /// False, and nothing is changed, while busy(). Context: the device's bucket.
  bool start(const std::uint8_t* bytes, std::size_t size, std::size_t reply_size);

  /// What became of the last question. Also carries the bus on. Context: the device's bucket.
  [[nodiscard]] SlotState state();
  /// A question waits or is under way. Also carries the bus on. Context: the device's bucket.
  [[nodiscard]] bool busy() { return is_under_way(state()); }
  /// The answer, as many bytes as were asked for; valid in SlotState::kDone. Context: the device's bucket.
  [[nodiscard]] const std::uint8_t* reply() const { return reply_; }
  /// True after kUnreachableAfter questions in a row have failed. Context: the device's bucket.
  [[nodiscard]] bool unreachable() const { return failures_ >= kUnreachableAfter; }
  [[nodiscard]] std::uint8_t id() const { return id_; }              ///< the device's `id` in the URDF
  [[nodiscard]] std::uint8_t priority() const { return priority_; }  ///< 0 is the most urgent

 private:
  friend class Rs485;
  Rs485* const bus_;
  const std::uint8_t* bytes_ = nullptr;
  std::uint16_t size_ = 0, reply_size_ = 0;
  std::uint8_t id_, priority_, failures_ = 0;
  AtStart<std::uint32_t> place_{0};  ///< in the table of the bus
  Shared<SlotState> state_{SlotState::kIdle};
  std::uint8_t reply_[kMaxReply]{};
};

/// One RS-485 line. It has no interrupt of its own: whoever looks at a slot, or supervise(), carries it on; a caller
/// that preempts another leaves the work to it.
class Rs485 {
 public:
  /// @param port   the board's; its driver takes direction from the hardware, or from a pin
  /// @param baud   bit rate [bit/s]
  /// @param ring   keeps what comes until it is read
  /// @param slots  every slot of this line, most urgent first
  template <std::size_t N>
  constexpr Rs485(UartPort& port, std::int64_t baud, UartRing ring, Rs485Slot* const (&slots)[N])
      : port_(&port), ring_(ring), slots_(slots), count_(N), baud_(baud), byte_time_(10 * 1000000000LL / baud) {
    static_assert(N <= kMaxSlots, "too many devices on one RS-485 line");
  }
  /// A line without devices.
  constexpr Rs485(UartPort& port, std::int64_t baud, UartRing ring)
      : port_(&port), ring_(ring), slots_(nullptr), count_(0), baud_(baud), byte_time_(10 * 1000000000LL / baud) {}

  static constexpr std::size_t kMaxSlots = 255;  ///< devices

  /// Sets the port up. Context: init.
  void start();
  /// Carries the line on, and ends an overdue question. Context: fastest bucket.
  void supervise() {
    const MarkedWork<Work::supervise_rs485> marked;
    carry_on();
  }

  /// Carries the line on; true when no slot waits or is served. Context: init, when no bucket runs.
  [[nodiscard]] bool quiet();
  /// What the line has done and suffered. Context: any.
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  friend class Rs485Slot;
  static constexpr std::size_t kWords = kMaxSlots / 32 + 1;

  void carry_on();
  void take_reply();
  void pick();
  void look_at_slots();
  void ask(Rs485Slot& slot);
  void finish(SlotState result);

  UartPort* const port_;
  const UartRing ring_;
  Rs485Slot* const* const slots_;
  const std::uint8_t count_;
  const std::int64_t baud_;
  const Duration byte_time_;
  Shared<bool> busy_{false};
  Shared<std::uint32_t> waiting_[kWords];  ///< a bit for each slot, by its place: looked at without a look at the slots
  Rs485Slot* active_ = nullptr;
  std::uint32_t reply_from_ = 0;
  Time deadline_ = 0;
  BusCounters counters_;
};

}  // namespace finemote
