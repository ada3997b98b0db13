// Turns the frames of several devices into one CAN bus: latest received frame per device, grouped commands, priorities.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/at_start.hpp"
#include "finemote/bus_counters.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

class CanBus;

/// Where the last frame with one of a few identifiers is kept.
class CanInbox {
 public:
  /// @param ids   identifiers that are kept here
  /// @param next  where frames with further identifiers of the device are kept; null: there are none
  constexpr explicit CanInbox(CanIds ids, CanInbox* next = nullptr) : ids_(ids), next_(next) {}

  /// A frame, and when it was made.
  struct Received {
    CanFrame frame;           ///< with its identifier
    Time at = kLongAgo;       ///< not later than the device made it, see CanBus::on_frame()
    std::uint32_t count = 0;  ///< frames so far, modulo 2^31; 0: none yet
  };
  /// The last frame received, whole. Context: the device's bucket.
  [[nodiscard]] Received received() const;

 private:
  friend class CanBus;
  friend class CanSlot;
  void store(const CanFrame& frame, Time at);

  const CanIds ids_;
  Shared<std::uint32_t> changes_{0};  ///< twice the frames so far; odd while one is being stored
  Time at_ = kLongAgo;
  CanFrame in_;
  CanInbox* const next_;
};

/// A device's bytes in a command frame that several devices fill.
struct CanShare {
  std::uint16_t frame = 0;  ///< identifier
  std::uint8_t offset = 0;  ///< of its first byte
  std::uint8_t width = 0;   ///< bytes; 0: it shares no frame
};

/// One device on a CAN bus: the last frames it sent to us, its part of a shared frame, and one frame to send.
class CanSlot {
 public:
  static constexpr std::int32_t kAnyTime = INT32_MAX;  ///< nobody knows how long its frames wait

  /// @param bus       whose table names the slot
  /// @param id        the device's `id` in the URDF
  /// @param receives  identifiers of the frames it sends to us
  /// @param waits     no less than the longest from when the device has such a frame until its last bit is on the bus
  ///                  [ns], as the timing analysis bounds it; kAnyTime; any where it receives none
  /// @param priority  0 is the most urgent: the index of the bucket, shortest period first
  /// @param share     its bytes in a command frame
  /// @param more      where frames with further identifiers are kept, in the order of its descriptor
  constexpr CanSlot(CanBus& bus, std::uint16_t id, CanIds receives, std::int32_t waits, std::uint8_t priority,
                    CanShare share = {}, CanInbox* more = nullptr)
      : bus_(&bus), id_(id), priority_(priority), share_(share), waits_(waits), inbox_(receives, more) {}

  using Received = CanInbox::Received;  ///< a frame, and when it was made
  /// The last frame received of entry `entry` of the descriptor's "receives", whole; of an entry it has not: none.
  /// Context: the device's bucket.
  [[nodiscard]] Received received(unsigned entry = 0) const;

  /// Sends one frame; false while the one before still waits. Context: the device's bucket.
  bool send(const CanFrame& frame);

  /// Sets the device's bytes, share().width of them, in the frame it shares; the flush() of its bucket sends it.
  /// False where it shares none, and when the bus keeps no more frames. Context: the device's bucket; safe().
  bool set_shared(const std::uint8_t* bytes);
  [[nodiscard]] const CanShare& share() const { return share_; }  ///< its bytes in a command frame

  [[nodiscard]] std::uint16_t id() const { return id_; }             ///< the device's `id` in the URDF
  [[nodiscard]] std::uint8_t priority() const { return priority_; }  ///< 0 is the most urgent
  [[nodiscard]] CanBus& bus() const { return *bus_; }                ///< the bus that carries its frames

 private:
  friend class CanBus;
  [[nodiscard]] Time made(Time busy_since, Time arrival) const;

  CanBus* const bus_;
  const std::uint16_t id_;
  const std::uint8_t priority_;
  CanFrame out_;
  const CanShare share_;
  const std::int32_t waits_;
  AtStart<std::uint32_t> group_{UINT32_MAX};  ///< of the bus; too large: it is looked for
  AtStart<std::uint32_t> place_{0};           ///< in the table of the bus
  CanInbox inbox_;
};

/// One CAN bus.
class CanBus {
 public:
  /// @param port     the board's
  /// @param bitrate  bit/s
  /// @param slots    every slot of this bus, most urgent first
  template <std::size_t N>
  constexpr CanBus(CanPort& port, std::int64_t bitrate, CanSlot* const (&slots)[N])
      : port_(&port), slots_(slots), count_(N), bitrate_(bitrate), longest_frame_(longest_frame(bitrate)) {
    static_assert(N <= kMaxSlots && kMaxSlots <= 32 && kGroups <= 32, "too many devices on one CAN bus");
  }
  /// A bus without devices.
  constexpr CanBus(CanPort& port, std::int64_t bitrate)
      : port_(&port), slots_(nullptr), count_(0), bitrate_(bitrate), longest_frame_(longest_frame(bitrate)) {}
  static constexpr std::size_t kMaxSlots = 32;  ///< devices
  static constexpr std::size_t kGroups = 5;     ///< shared command frames

  /// Sets the port up. Context: init.
  void start();
  /// Brings a controller that went off the bus back, with groups set to zero first; drops frames that nobody
  /// acknowledges. Context: fastest bucket.
  void supervise();
  /// Calls `accept(const CanIds&)` with each entry of what the devices receive. Context: init.
  template <typename Accept>
  void each_ids(Accept&& accept) const;
  /// A frame arrived. It may have waited for as long as the bus had been busy without a pause, or for as long as such
  /// frames wait at most: then it was made at the earliest, and that is the time it is kept with. One that came before
  /// the first release is not kept: its age is not known. Context: interrupt.
  void on_frame(const CanFrame& frame, Moment arrival);
  /// A frame came when there was no room for it. Context: interrupt.
  void on_overrun() { ++counters_.lost; }
  /// A pended interrupt, or a mailbox that fell free. Context: interrupt.
  void on_interrupt();

  /// Sends every group that was set since the last flush, once. Context: init, safe stop.
  void flush();
  /// The same of those that devices of this priority set: a group that a slower bucket has set in part waits for its
  /// end. Context: end of the bucket.
  void flush(std::uint8_t priority);

  /// Since nothing of ours waits any more the bus was idle once: nobody's frame waits behind what the start-up sent.
  /// Waits for eleven bits at most. Context: init, when no bucket runs.
  [[nodiscard]] bool quiet();
  /// True while the controller is off the bus, or nobody acknowledges. Context: any.
  [[nodiscard]] bool unreachable() const { return port_->bus_off() || transmit_errors() > kErrorPassive; }
  /// Error counters of the controller (ISO 11898-1): above 127 it is passive; 256 transmit errors put it off the bus.
  /// Context: any.
  [[nodiscard]] std::uint8_t transmit_errors() const {
    return static_cast<std::uint8_t>(port_->error_counters() & 0xFFU);
  }
  /// The same of reception. Context: any.
  [[nodiscard]] std::uint8_t receive_errors() const { return static_cast<std::uint8_t>(port_->error_counters() >> 8); }
  /// What the bus has done and suffered. Context: any.
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  friend class CanSlot;
  /// The count of errors above which a controller is passive: ISO 11898-1.
  static constexpr std::uint8_t kErrorPassive = 127;
  /// A frame of eight bytes with all stuff bits, and the three bits between frames: ISO 11898-1.
  static constexpr std::int64_t kLongestFrameBits = 135;
  static constexpr std::int32_t longest_frame(std::int64_t bitrate) {
    return static_cast<std::int32_t>(kLongestFrameBits * kSecond / bitrate);
  }

  /// When some frames kept the bus busy without a pause.
  struct Busy {
    Time since = kLongAgo, until = kLongAgo;
    /// When it began where it lasted until `at`, else `at`.
    [[nodiscard]] constexpr Time reach(Time at) const { return at <= until ? oldest(at, since) : at; }
    constexpr void last_to(Time at) { until = until < at ? at : until; }
  };
  /// Frames of ours may begin twice while the end of a received one waits for its routine: what was sent before counts.
  static constexpr unsigned kSentKept = 3;

  /// A command frame of eight bytes that several devices fill.
  struct Group {
    Shared<std::uint16_t> id{0};  ///< 0: free
    CanFrame frame;
    Shared<std::uint8_t> cleared{0};  ///< times all bytes went to zero
    Shared<bool> changed{false};
    Shared<std::uint8_t> priority{0};  ///< of the devices that fill it, which share a bucket
  };

  /// A frame that waits for a mailbox, and what says so; null: none does.
  struct Next {
    const CanFrame* frame = nullptr;
    Shared<std::uint32_t>* waiting = nullptr;
    std::uint32_t own = 0;  ///< its bit there
  };

  void request() { port_->pend(); }
  bool set_shared(const CanSlot& slot, const std::uint8_t* bytes);
  template <typename Belongs>
  void flush_if(Belongs&& belongs);
  [[nodiscard]] std::uint8_t first_sharing(std::uint8_t slot) const;
  void assign_places();
  [[nodiscard]] Group* group_of(const CanSlot& slot);
  [[nodiscard]] Group* find_group(std::uint16_t id);
  static void write(Group& group, const CanShare& share, const std::uint8_t* bytes);
  [[nodiscard]] Next first_waiting();
  void send(const Next& next, Time at);
  Time busy_since(Moment arrival);
  void begin_recovery(Time at);
  void silence();

  CanPort* const port_;
  CanSlot* const* const slots_;
  const std::uint8_t count_;
  const std::int64_t bitrate_;
  const std::int32_t longest_frame_;  ///< ns
  Busy received_;
  Busy sent_[kSentKept];  ///< the last one first
  bool was_idle_ = false;
  bool recovering_ = false;
  bool returning_ = false;  ///< recovering, and the controller has begun to count the bits it waits for
  Time try_again_ = 0;      ///< a recovery that has not ended by then is begun anew
  // A bit for each group, and for each slot by its place. Interrupt routines look at them without a loop.
  Shared<std::uint32_t> waiting_groups_{0}, waiting_slots_{0};
  Shared<std::uint32_t> setting_groups_{0};  ///< a device's bytes are half written: they are not sent now
  Shared<std::uint32_t> silent_groups_{0};   ///< their zeros after a recovery are still to be sent
  Group groups_[kGroups];
  BusCounters counters_;
};

template <typename Accept>
void CanBus::each_ids(Accept&& accept) const {
  for (std::uint8_t i = 0; i < count_; ++i) {
    for (const CanInbox* inbox = &slots_[i]->inbox_; inbox != nullptr; inbox = inbox->next_) {
      if (inbox->ids_.count > 0) accept(inbox->ids_);
    }
  }
}

}  // namespace finemote
