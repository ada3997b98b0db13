// Turns the frames of several devices into one CAN bus: latest received frame per device, grouped commands, priorities.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/bus_counters.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

class CanBus;

/// One device on a CAN bus: the last frame with its receive identifier, and one frame to send.
class CanSlot {
 public:
  /// @param id        the device's `id` in the URDF
  /// @param receives  identifier of the frames it sends to us
  /// @param priority  0 is the most urgent: the index of the bucket, shortest period first
  constexpr CanSlot(CanBus& bus, std::uint16_t id, std::uint16_t receives, std::uint8_t priority)
      : bus_(&bus), id_(id), receives_(receives), priority_(priority) {}

  struct Received {
    CanFrame frame;
    Time at = 0;
    std::uint32_t count = 0;  ///< frames so far, modulo 2^31; 0: none yet
  };
  /// The last frame received, whole. Context: the device's bucket.
  [[nodiscard]] Received received() const;

  /// Sends one frame; false while the one before still waits. Context: the device's bucket.
  bool send(const CanFrame& frame);

  [[nodiscard]] std::uint16_t id() const { return id_; }
  [[nodiscard]] std::uint8_t priority() const { return priority_; }
  [[nodiscard]] CanBus& bus() const { return *bus_; }

 private:
  friend class CanBus;
  CanBus* bus_;
  std::uint16_t id_, receives_;
  std::uint8_t priority_;
  Shared<bool> waiting_{false};
  CanFrame out_;
  Shared<std::uint32_t> changes_{0};  ///< twice the frames so far; odd while one is being stored
  CanFrame in_;
  Time at_ = 0;
};

/// One CAN bus.
class CanBus {
 public:
  template <std::size_t N>
  constexpr CanBus(CanPort& port, std::int64_t bitrate, CanSlot* const (&slots)[N])
      : port_(&port), slots_(slots), count_(N), bitrate_(bitrate) {
    static_assert(N <= kMaxSlots, "too many devices on one CAN bus");
  }
  constexpr CanBus(CanPort& port, std::int64_t bitrate) : port_(&port), slots_(nullptr), count_(0), bitrate_(bitrate) {}
  static constexpr std::size_t kMaxSlots = 32;
  static constexpr std::size_t kGroups = 5;  ///< shared command frames

  /// Context: init.
  void start();
  /// Brings a controller that went off the bus back, with groups set to zero first; drops frames that nobody
  /// acknowledges. Context: fastest bucket.
  void supervise();
  /// Context: interrupt.
  void on_frame(const CanFrame& frame, Time at);
  void on_interrupt();

  /// Sets one of the four big-endian words of the shared command frame `id` (DJI ESCs take one frame for four motors).
  /// Sent by the next flush(). False when all groups are taken by other identifiers. Context: any bucket.
  bool set_group(std::uint16_t id, unsigned index, std::int16_t value);
  /// Sends every group that was set since the last flush, once. Context: end of any bucket that drives it.
  void flush();

  /// Context: any.
  [[nodiscard]] bool unreachable() const { return port_->bus_off(); }
  /// Error counters of the controller (ISO 11898-1): above 127 it is passive; 256 transmit errors put it off the bus.
  /// Context: any.
  [[nodiscard]] std::uint8_t transmit_errors() const {
    return static_cast<std::uint8_t>(port_->error_counters() & 0xFFU);
  }
  [[nodiscard]] std::uint8_t receive_errors() const { return static_cast<std::uint8_t>(port_->error_counters() >> 8); }
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  friend class CanSlot;
  struct Group {
    Shared<std::uint16_t> id{0};  ///< 0: free
    Shared<std::uint16_t> words[4];
    Shared<bool> changed{false}, waiting{false};
  };

  void request() { port_->pend(); }
  bool send_group(Group& group);

  CanPort* port_;
  CanSlot* const* slots_;
  std::uint8_t count_;
  std::int64_t bitrate_;
  bool recovering_ = false;
  Time try_again_ = 0;  ///< a recovery that has not ended by then is begun anew
  Group groups_[kGroups];
  BusCounters counters_;
};

}  // namespace finemote
