// What the kinds of bus do with frames: how long a unit takes, how often it interrupts, and who may begin one.
#pragma once

#include <string_view>

#include "generator/descriptor/bus_kind.hpp"
#include "generator/timing/integer.hpp"

namespace finemote::gen::timing {

/// What one unit on a bus takes.
struct UnitBits {
  Ns bits = 0;
  Ns interrupts = 0;
};

/// One kind of bus. The row of a kind says all that the timing analysis knows of it.
struct BusTraffic {
  /// Which interrupts are known to belong to transfers that devices ask for.
  enum class Counted {
    none,    ///< parts send by themselves
    always,  ///< all of them
    by_dma,  ///< the begin and the end of a transfer, where a DMA moves its bytes; else every byte interrupts
  };

  /// Of bytes written and read in one unit; null: a kind without frames.
  UnitBits (*unit)(Ns write, Ns read, Ns bits_per_byte) = nullptr;
  bool has_two_lines = false;  ///< what a part sends by itself meets nothing that is sent to it
  bool is_arbitrated = false;  ///< identifiers decide what goes first
  bool is_mastered = false;    ///< nothing happens that no device begins
  Counted counted = Counted::none;
  bool is_shared = false;  ///< parts can move from one bus of the kind to another without other pins of their own
};

const BusTraffic& traffic_of(BusKind kind);

/// Bits of one byte on a serial line of that format (`8N1`: 10).
Ns bits_per_byte(std::string_view format);

struct WireRate {
  BusKind kind = BusKind::uart;
  Ns bits_per_s = 1;
  Ns bits_per_byte = 10;  ///< uart, rs485: start, data, parity and stop bits
};

/// Time on the wire and service routines of what goes over a bus together, one unit after the other.
struct WireUse {
  Ns wire_ns = 0;
  Ns interrupts = 0;
  Ns min_interval_ns = 0;

  /// Throws Overflow.
  void add(const WireRate& rate, Ns write, Ns read);
};

}  // namespace finemote::gen::timing
