// What the timing analysis knows about a robot: tick, buses and devices in registration order, as plain integers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/source.hpp"
#include "generator/index/ids.hpp"
#include "generator/timing/integer.hpp"

namespace finemote::gen::timing {

/// Place of a bus in Model::buses.
using BusPlace = Index<struct BusPlaceSpace>;

/// At most `count` interrupts of a source in one of any `every` consecutive periods of `device`, none in the others;
/// the driver counts and refuses more.
struct FrameBudget {
  Rank device;
  Ns count = 0;
  Ns every = 1;  ///< >= 1
};

/// One interrupt of a bus (receive, transmit complete, ...). Only profile `target` tells sources apart.
struct InterruptSource {
  std::string name;
  Ns wcet_ns = 0;                    ///< one run of its service routine
  Ns min_interval_ns = 0;            ///< >= 1; two interrupts are never closer
  std::vector<FrameBudget> budgets;  ///< empty: only the interval bounds it
};

/// What a message can offer where a bus is too slow; empty where nobody knows.
struct BusAdvice {
  struct Rate {
    std::string text;  ///< `clock="400kHz"`
    Ns bps = 0;
  };
  std::vector<Rate> rates;   ///< faster ones that its port and its devices make, rising
  std::vector<Rate> slower;  ///< slower ones, falling
  std::string other_port;    ///< `<bus ... port="i2c3" .../>`: another one of its kind
};

struct Bus {
  std::string name;
  Ns baud_bps = 1;
  Ns min_frame_bits = 1;
  Ns wcet_ns = 0;                                       ///< one run of the service routine
  Ns frame_ns = 1;                                      ///< floor(min_frame_bits * 1e9 / baud_bps), >= 1
  std::optional<std::vector<InterruptSource>> sources;  ///< target; none: one source of frame_ns and wcet_ns
  bool arbitrated = false;  ///< identifiers, which are not known here, decide what goes first (CAN)
  Position at;
  BusAdvice advice;
};

/// Use of a bus once per period of the device (or, sent by the part itself, once per interval). Everything that waits
/// for a bus is taken in rate-monotonic order (where the bus is not arbitrated), a begun transfer runs to its end.
struct Transfer {
  enum class After { update, handle, bucket, autonomous };  ///< what hands it to the bus
  BusPlace bus;
  Ns wire_ns = 0;  ///< first to last bit of the whole unit, mux selection included
  After after = After::handle;
  Ns min_interval_ns = 0;        ///< autonomous: between two of them; 0: the device's period
  Ns interrupts = 1;             ///< service routines on its way that the wire waits for
  bool command = false;          ///< carries the device's command: its last bit is the end of a chain
  bool receive = false;          ///< on the receive line of a bus with two lines: meets nothing that is sent
  std::optional<Ns> identifier;  ///< of its one frame on a bus that arbitrates; none: more urgent than any other
};

/// How old a sample can be when update() reads it.
///
/// The part sends by itself (periods = 0): fixed + interval + wire of its frame. The device asks for it: fixed +
/// (periods + extra) T + (every - 1)(1 + extra) T + R+, with as many extra periods as the conversion does not fit into.
struct Acquisition {
  Ns fixed_ns = 0;           ///< filter and transport delay
  Ns interval_ns = 0;        ///< an autonomous part's largest distance between samples
  std::int64_t periods = 0;  ///< own periods from the begin of a measurement to the update that publishes it
  std::int64_t every = 1;    ///< one in this many measurements is published at least
  Ns conversion_ns = 0;      ///< longest conversion
  bool assumed = false;      ///< not from a data sheet or a measurement
};

enum class WcetSource { unknown, assumed, budget, measured, static_analysis };

struct Device {
  std::string name;
  std::optional<Rank> parent;  ///< larger than the device's own
  Ns period_ns = 1;
  Ns update_wcet_ns = 0;
  Ns handle_wcet_ns = 0;
  // what follows belongs to profile `target` and to chains
  Ns update_bcet_ns = 0;
  Ns handle_bcet_ns = 0;
  Ns update_extra_ns = 0;  ///< snapshots and publishing the schedule adds around update()
  Ns handle_extra_ns = 0;  ///< the same around handle()
  Ns output_ns = 0;        ///< end of handle() to the output where no bus is in between (a timer's next period)
  bool takes_command = true;
  bool actuator = false;    ///< its command leaves the robot's software here
  std::vector<Rank> reads;  ///< observed devices outside the own subtree
  /// Children and observed devices whose data end here: they are no part of the commands this device sends.
  std::vector<Rank> ends_here;
  std::string role;  ///< in the parent; empty: not known
  std::optional<Acquisition> acquisition;
  std::vector<Transfer> transfers;
  WcetSource source = WcetSource::unknown;
  Position at;
};

/// What the processor and the scheduler cost (profile `target`); zero where not given.
struct Costs {
  Ns release_ns = 0;             ///< one release interrupt, entry and exit included
  Ns release_per_bucket_ns = 0;  ///< for every bucket due
  Ns interrupt_ns = 0;           ///< exception entry and exit, added to every bus interrupt
  Ns job_ns = 0;                 ///< exception entry and exit and bookkeeping of one job of a bucket
  Ns stage_ns = 0;               ///< dispatch of one update or handle
  Ns masked_ns = 0;              ///< longest time with interrupts masked
};

/// Work at the end of every job of one bucket: one shared output is written, once for all devices on it.
struct Flush {
  Ns period_ns = 1;
  Ns wcet_ns = 0;
  std::optional<BusPlace> bus;  ///< where its transfer goes; none: no transfer
  Ns wire_ns = 0;
  Ns interrupts = 1;
  std::vector<Ns> identifiers;  ///< of its frames, all equally long, on a bus that arbitrates; empty: not known
  std::vector<Rank> devices;    ///< whose commands it carries
  /// Flushes with the same output share a slot; if it is busy, the next flush sends the data.
  std::string output;
};

struct Model {
  Ns tick_ns = 1;
  Table<BusPlace, Bus> buses;
  Table<Rank, Device> devices;  ///< registration order: every child before its parent
  // profile `target`
  Costs costs;
  std::vector<Flush> flushes;
  bool has_target = false;  ///< some field beyond the plain case format was given
};

}  // namespace finemote::gen::timing
