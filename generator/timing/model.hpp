// What the timing analysis knows about a robot: tick, buses and devices in registration order, as times and counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/source.hpp"
#include "generator/index/ids.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

/// Place of a bus in Model::buses.
using BusPlace = Index<struct BusPlaceSpace>;

/// What lets an interrupt of a budget come.
enum class InterruptCause {
  clock,     ///< nothing that our jobs do: a part that sends by itself, or something unknown
  request,   ///< a stage or flush that asks for a transfer, at once
  transfer,  ///< the transfer asked for: after the request, and before the end of the transfer
  look,      ///< a look at a line by update() of the device: it allows a number of them until the next look
};

/// Which part of a job asks for a transfer: a stage of the device, or the flush after all stages.
enum class AskedIn { handle, update, flush };

/// What an execution time rests on: nothing that the model says, a type's default, what the user declares, the longest
/// that was seen, a bound that was computed from the image.
enum class WcetSource { unknown, assumed, declared, measured, computed };

/// At most `count` interrupts of a source in one of any `every` consecutive periods of `device`, none in the others;
/// the driver counts and refuses more.
struct FrameBudget {
  Rank device;
  std::int64_t count = 0;
  std::int64_t every = 1;     ///< >= 1
  Duration interval;          ///< of what its part sends by itself; 0: the period of the device
  std::int64_t carry_in = 1;  ///< periods before a window whose interrupts can still come in it
  InterruptCause cause = InterruptCause::clock;
  AskedIn asked_in = AskedIn::handle;  ///< request, transfer
};

/// A pin that a device has to itself.
struct DevicePin {
  Rank device;
  std::string name;  ///< `PA0`
};

/// One interrupt of a bus (receive, transmit complete, ...). Only profile `target` tells sources apart.
struct InterruptSource {
  std::string name;
  Duration wcet;                     ///< one run of its service routine
  Duration min_interval;             ///< >= 1 ns; two interrupts are never closer
  std::vector<FrameBudget> budgets;  ///< empty: only the interval bounds it
  bool of_transfers = false;  ///< only the transfer that is on the wire causes it, of which there is one at a time
  bool ends_frame = false;  ///< the end of a frame on the wire causes it, as it does the others of the bus that say so
  bool steals = false;      ///< no routine: the DMA delays accesses of the core, this long for one byte
  WcetSource source = WcetSource::unknown;
  std::optional<DevicePin> pin = {};  ///< whose edges cause it
};

/// What a message can offer where a bus is too slow; empty where that is unknown.
struct BusAdvice {
  struct Rate {
    std::string text;  ///< `clock="400kHz"`
    std::int64_t bps = 0;
  };
  std::vector<Rate> rates;   ///< faster ones that its port and its devices make, rising
  std::vector<Rate> slower;  ///< slower ones, falling
  std::string other_port;    ///< `<bus ... port="i2c3" .../>`: another one of its kind
};

struct Bus {
  std::string name;
  std::int64_t baud_bps = 1;
  std::int64_t min_frame_bits = 1;
  Duration wcet;                                        ///< one run of the service routine
  Duration frame = nanoseconds(1);                      ///< min_frame_bits at baud_bps, rounded down, >= 1 ns
  std::optional<std::vector<InterruptSource>> sources;  ///< target; none: one source of frame and wcet
  bool arbitrated = false;  ///< identifiers, which are not known here, decide what goes first (CAN)
  bool polled = false;      ///< jobs of the fastest bucket, and of those that use it, carry it on; nothing else does
  bool is_pins =
      false;  ///< no bus, but the lines that interrupt of devices on no bus: its sources alone mean something
  Position at;
  BusAdvice advice;
};

/// Why it is unknown how old the data of a device are, where its part sends it some.
enum class UnknownAge {
  none,              ///< it is known, or there are none
  no_acquisition,    ///< nothing says so
  sent_by_itself,    ///< its part sends some by itself, and its type says that it is asked
  busy_slot,         ///< a measurement may find its slot taken by another transfer of the device
  shared_converter,  ///< another input is measured with the same converter, which drops what nobody has taken
};

/// Use of a bus once per period of the device (or, sent by the part itself, once per interval). Everything that waits
/// for a bus is taken in rate-monotonic order (where the bus is not arbitrated), a begun transfer runs to its end.
struct Transfer {
  enum class After { update, handle, bucket, autonomous };  ///< what hands it to the bus
  BusPlace bus;
  Duration wire;  ///< first to last bit of the whole unit, mux selection included
  After after = After::handle;
  Duration min_interval;        ///< autonomous: between two of them; 0: the device's period
  std::int64_t interrupts = 1;  ///< service routines on its way that the wire waits for
  Duration service;             ///< how long those routines run, of_transfers: no others do on its bus; 0: not known
  std::int64_t frames = 1;      ///< on a bus that arbitrates: others may go between them
  bool command = false;         ///< carries the device's command: its last bit is the end of a chain
  bool reads = false;           ///< something comes back
  bool writes = false;          ///< something is sent; known of robots alone
  bool sets = false;            ///< a frame of it brings nothing back; the same
  std::int64_t slot =
      0;  ///< transfers of the device with one number take turns: one is under way at a time; 0: none do
  std::int64_t turns = 1;  ///< that it takes there
  bool receive = false;    ///< on the receive line of a bus with two lines: meets nothing that is sent
  std::optional<std::int64_t>
      identifier;  ///< of its one frame on a bus that arbitrates; none: more urgent than any other
};

/// How old a sample can be when update() reads it.
///
/// The part sends by itself (periods = 0): fixed + interval + wire of its frame. The device asks for it: fixed +
/// (periods + extra) T + (every (begun_every + extra) - 1) T + R+, with as many extra periods as each of the
/// conversions does not fit into. It asks a part that measures by itself: the same with periods = 1, and the interval;
/// where that part sends, too, the larger of both.
struct Acquisition {
  Duration fixed;                ///< filter and transport delay
  Duration interval;             ///< an autonomous part's largest distance between samples
  std::int64_t periods = 0;      ///< own periods from the start of a measurement to the update that publishes it
  std::int64_t begun_every = 1;  ///< own periods from the start of a measurement to that of the next
  std::int64_t every = 1;        ///< one in this many measurements is published at least
  Duration conversion;           ///< longest conversion
  std::int64_t conversions = 1;  ///< one after the other, in one measurement
  bool assumed = false;          ///< not from a data sheet or a measurement
};

struct Device {
  std::string name;
  std::optional<Rank> parent;  ///< larger than the device's own
  Duration period = nanoseconds(1);
  Duration update_wcet;
  Duration handle_wcet;
  // what follows belongs to profile `target` and to chains
  Duration update_bcet;
  Duration handle_bcet;
  Duration update_extra;   ///< snapshots and publishing the schedule adds around update()
  Duration handle_extra;   ///< the same around handle()
  Duration output;         ///< end of handle() to the output where no bus is in between (a timer's next period)
  bool sets_late = false;  ///< its outputs without a bus, and what flushes send, are set by the update() after handle()
  bool takes_command = true;
  bool actuator = false;    ///< its command leaves the robot's software here
  std::vector<Rank> reads;  ///< observed devices outside the own subtree
  /// Children and observed devices whose data end here: they are no part of the commands this device sends.
  std::vector<Rank> ends_here;
  std::string role;  ///< in the parent; empty: not known
  std::optional<Acquisition> acquisition;
  UnknownAge unknown_age = UnknownAge::none;
  std::vector<Transfer> transfers;
  /// Buses over which it may send what is not among its transfers: nothing that goes over them has a bound.
  std::vector<BusPlace> undeclared;
  WcetSource source = WcetSource::unknown;
  std::optional<Duration> update_static, handle_static;  ///< computed from the image
  bool is_above_declared = false;                        ///< what was computed is above what the user declares
  Position at;
};

/// What the processor and the scheduler cost (profile `target`); zero where not given.
struct Costs {
  Duration release;                ///< one release interrupt, entry and exit included
  Duration release_per_bucket;     ///< for every bucket due
  Duration interrupt;              ///< exception entry and exit, added to every bus interrupt
  Duration job;                    ///< exception entry and exit and bookkeeping of one job of a bucket
  Duration stage;                  ///< dispatch of one update or handle
  Duration masked;                 ///< longest time with interrupts masked
  bool keeps_one_release = false;  ///< the timer: of releases that wait for their interrupt, all but one are lost
  /// Where all periods are longer than the timer can count: it interrupts in between, too, at this distance. 0: never.
  Duration longest_release = {};
  Duration event_entry;  ///< assumed from an event of a bus to the start of its routine, to date the event
  Duration event_pause;  ///< between two routines that count as one row: an event is no older than the row
  WcetSource source = WcetSource::unknown;  ///< of the release, of what jobs take beside their stages, and of masked
};

/// Work at the end of every job of one bucket: one shared output is written, once for all devices on it.
struct Flush {
  Duration period = nanoseconds(1);
  Duration wcet;
  std::optional<BusPlace> bus;  ///< where its transfer goes; none: no transfer
  Duration wire;
  std::int64_t interrupts = 1;
  Duration service;  ///< as of a Transfer
  std::vector<std::int64_t>
      identifiers;            ///< of its frames, all equally long, on a bus that arbitrates; empty: not known
  std::vector<Rank> devices;  ///< whose commands it carries
  /// Flushes with the same output share a slot; if it is busy, the next flush sends the data.
  std::string output;
};

struct Model {
  Duration tick = nanoseconds(1);
  Table<BusPlace, Bus> buses;
  Table<Rank, Device> devices;  ///< registration order: every child before its parent
  // profile `target`
  Costs costs;
  std::vector<Flush> flushes;
  /// All times of a model are by the board's clock, which may be off by this much, both ways; bounds are true time.
  std::int64_t clock_ppm = 0;
  bool has_target = false;  ///< some field beyond the plain case format was given
};

}  // namespace finemote::gen::timing
