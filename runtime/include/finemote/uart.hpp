// Turns a serial port's endless receive ring and block sender into read() and write() for the one device on the line.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/bus_counters.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

/// What a serial line may cost from one update() of its device to the next, whatever comes.
struct UartLimits {
  std::uint16_t events = 16;  ///< idle lines and damaged bytes that interrupt
  std::uint16_t bytes = 256;  ///< that read() returns
};

/// One serial line. Reception needs no call at all; the hardware fills the ring. One device reads and writes it, from
/// one bucket.
class Uart {
 public:
  /// Room for what one read() returns under the default limits, and a byte: it returns less, so that it is the last of
  /// an update().
  static constexpr std::size_t kChunk = UartLimits{}.bytes + 1;

  /// @param port    the board's
  /// @param baud    bit rate [bit/s]
  /// @param ring    keeps what comes until it is read
  /// @param format  bits on the line
  /// @param limits  what the line may cost, whatever comes
  constexpr Uart(UartPort& port, std::int64_t baud, UartRing ring, UartFormat format = UartFormat::k8N1,
                 UartLimits limits = {})
      : port_(&port),
        ring_(ring),
        baud_(static_cast<std::int32_t>(baud)),
        bit_time_(static_cast<std::int32_t>((1000000000LL + baud - 1) / baud)),
        format_(format),
        limits_(limits),
        left_(limits.bytes) {}

  /// Sets the port up; reception begins. Context: init.
  void start();

  /// Copies the bytes received since the last call, oldest first, at most `capacity`, and returns how many. Bytes the
  /// ring has lost (nobody read for a whole ring) or overwrote during the copy are dropped and counted, never returned.
  /// After a DMA error it restarts reception. An update() calls it until it returns less than `capacity`, and not
  /// again: then nothing is left, or the update has taken what UartLimits allow and the rest waits for the next one;
  /// and the line may raise its interrupts anew. Context: the device's bucket.
  std::size_t read(std::uint8_t* out, std::size_t capacity);

  /// Calls read() as often as an update() has to, and `take(size)` behind each: its bytes, which may be none, lie at
  /// `to` until the next one. Tools find a bound of this loop. Context: the device's bucket.
  /// @param to  room for `capacity` bytes
  template <class Take>
  [[gnu::always_inline]] void read_all(std::uint8_t* to, std::size_t capacity, Take take) {
    for (std::size_t left = full_reads(capacity) + 1; left != 0; --left) {
      const std::size_t size = read(to, capacity);
      take(size);
      if (size < capacity) return;
    }
  }

  /// Most calls of read() in one update() that return all they may, where each may return at least `capacity` bytes.
  /// Context: any.
  [[nodiscard]] std::size_t full_reads(std::size_t capacity) const { return limits_.bytes / capacity; }
  /// Most bytes that a read() with room for kChunk returns. Context: any.
  [[nodiscard]] std::size_t most_in_chunk() const { return limits_.bytes < kChunk ? limits_.bytes : kChunk; }

  /// Drops what came so far: the first update() finds what comes from here on, or the last of it that it may handle.
  /// True when nothing of ours is being sent. Context: init, when no bucket runs.
  [[nodiscard]] bool quiet();

  /// Sends a block; false, and nothing is sent, while the last one is still under way or `size` is above capacity(). A
  /// block that has not left within twice its wire time is aborted and counted. Context: the device's bucket.
  bool write(const std::uint8_t* bytes, std::size_t size);
  /// Most bytes of one write(), at least 64. Context: any.
  [[nodiscard]] std::size_t capacity() const { return port_->transmit_capacity(); }

  /// True when the line fell silent behind the last byte read() returned, whatever came since: a message without
  /// terminator is complete. Context: the device's bucket.
  [[nodiscard]] bool idle() const;
  /// Bytes read behind the last silence of the line that is known of. Context: the device's bucket.
  [[nodiscard]] std::size_t since_silence() const;

  /// A time not later than when a byte arrived: the one `behind` bytes before the last that read() returned. From the
  /// idle event right behind it; where there is none, from the read() or idle event before it and the wire time of the
  /// bytes since. Context: the device's bucket.
  [[nodiscard]] Time arrival(std::size_t behind = 0) const;

  /// A time not later than when the first of `bytes` bytes began, whose last is the one of arrival(): the sender's bits
  /// are taken to be as long as they can be where they are understood. Context: the device's bucket.
  [[nodiscard]] Time began(std::size_t behind, std::size_t bytes) const;

  /// Wire time of `bytes` bytes (start, 8 data, parity, stop bits), rounded up. Context: any.
  [[nodiscard]] Duration wire_time(std::size_t bytes) const;

  /// What the line has done and suffered. Context: any.
  [[nodiscard]] const BusCounters& counters() const { return counters_; }

 private:
  static constexpr std::uint16_t kFirst = UINT16_MAX;

  [[nodiscard]] static Duration longest(Duration nominal);
  [[nodiscard]] Duration longest_unseen(std::uint32_t behind) const;
  [[nodiscard]] Time earliest(const UartIdle& point, std::uint32_t position) const;
  std::size_t take(std::uint8_t* out, std::size_t capacity);
  void count_line_errors();
  void restart();
  void lose(std::uint32_t bytes);

  UartPort* const port_;
  const UartRing ring_;
  const std::int32_t baud_, bit_time_;  ///< bit/s, ns
  const UartFormat format_;
  const UartLimits limits_;
  std::uint16_t left_;             ///< bytes that read() may still return in this update(); kFirst: in the first one
  std::uint32_t read_ = 0;         ///< bytes taken since start, modulo 2^32
  std::uint32_t line_errors_ = 0;  ///< seen so far
  UartIdle seen_, before_;         ///< when the line had brought what is read, and less than that
  UartIdle idle_;                  ///< the last silence when what is read was counted
  Time send_deadline_ = 0;
  BusCounters counters_;
};

}  // namespace finemote
