// Turns a serial port's endless receive ring and block sender into read() and write() for the one device on the line.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/bus_counters.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

/// One serial line. Reception needs no call at all; the hardware fills the ring. One device reads and writes it, from
/// one bucket.
class Uart {
 public:
  /// Idle lines and damaged bytes that may interrupt between two looks at a line of which nobody says more.
  static constexpr std::uint16_t kUsualEvents = 16;

  /// @param baud    bit rate [bit/s]
  /// @param events  idle lines and damaged bytes that may interrupt from one read() to the next
  constexpr Uart(UartPort& port, std::int64_t baud, UartFormat format = UartFormat::k8N1,
                 std::uint16_t events = kUsualEvents)
      : port_(&port),
        baud_(static_cast<std::int32_t>(baud)),
        bit_time_(static_cast<std::int32_t>((1000000000LL + baud - 1) / baud)),
        format_(format),
        events_(events) {}

  /// Context: init.
  void start();

  /// Copies the bytes received since the last call, oldest first, at most `capacity`, and returns how many. Bytes the
  /// ring has lost (nobody read for a whole ring) or overwrote during the copy are dropped and counted, never returned.
  /// After a DMA error it restarts reception. Where it returns less than `capacity`, the line may raise its interrupts
  /// anew: an update() calls it until then, and not again. Context: the device's bucket.
  std::size_t read(std::uint8_t* out, std::size_t capacity);

  /// Sends a block; false, and nothing is sent, while the last one is still under way or `size` is above capacity(). A
  /// block that has not left within twice its wire time is aborted and counted. Context: the device's bucket.
  bool write(const std::uint8_t* bytes, std::size_t size);
  [[nodiscard]] std::size_t capacity() const { return port_->transmit_capacity(); }

  /// True when the line has been silent since the last byte read() returned: a message without terminator is complete.
  [[nodiscard]] bool idle() const;

  /// A time not later than when a byte arrived: the one `behind` bytes before the last that read() returned. From the
  /// idle event right behind it; where there is none, from the read() or idle event before it and the wire time of the
  /// bytes since.
  [[nodiscard]] Time arrival(std::size_t behind = 0) const;

  /// Wire time of `bytes` bytes (start, 8 data, parity, stop bits), rounded up.
  [[nodiscard]] Duration wire_time(std::size_t bytes) const;

  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  [[nodiscard]] Time earliest(const UartIdle& point, std::uint32_t position) const;
  std::size_t take(std::uint8_t* out, std::size_t capacity);
  void count_line_errors();
  void lose(std::uint32_t bytes);

  UartPort* port_;
  std::int32_t baud_, bit_time_;  ///< bit/s, ns
  UartFormat format_;
  std::uint16_t events_;
  std::uint32_t read_ = 0;         ///< bytes taken since start, modulo 2^32
  std::uint32_t line_errors_ = 0;  ///< seen so far
  UartIdle seen_, before_;         ///< when the line had brought what is read, and less than that
  Time send_deadline_ = 0;
  BusCounters counters_;
};

}  // namespace finemote
