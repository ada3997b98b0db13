// What there is to know about a kind of bus: a record, which each kind fills in a file of its own beside this one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "generator/bus/bus_kind.hpp"
#include "generator/bus/port_class.hpp"
#include "generator/bus/rate_form.hpp"
#include "generator/bus/rate_rule.hpp"

namespace finemote::gen {

/// The rate of a bus.
struct BusRate {
  const RateForm* form = nullptr;  ///< how tags write it; null: the kind has no rate, and the other members say nothing
  const RateRule* rule = nullptr;  ///< of ports whose board file names none; null: they make every rate in their range
  std::int64_t example = 0;        ///< what hints and pages show where nothing speaks against it [Hz or bit/s]
  bool may_be_left_out = false;    ///< then it is the fastest of the port
  bool offers_fastest = false;     ///< hints offer the fastest that all on the bus can do beside the usual rates
};

/// What moves the bytes of a transfer.
enum class Mover { routine, dma };

/// What goes over a bus together.
struct BusExchange {
  std::int64_t write = 0, read = 0;  ///< bytes, as a device has them
  std::int64_t bits_per_byte = 10;   ///< of a serial line; other kinds have one of their own
  Mover mover = Mover::routine;
  bool is_asked_for = true;  ///< by a device; else the part sends by itself
};

/// What bytes that go over a bus together take.
struct WireUnit {
  std::int64_t bits = 0;
  std::int64_t steps = 0;    ///< interrupts in the midst of it
  std::int64_t ends = 0;     ///< interrupts that end it, and begin what waits
  std::int64_t answers = 0;  ///< frames that a part sends because it was asked to
};

/// The class of the runtime that is such a bus. An empty name: the kind has no object.
struct BusClass {
  std::string_view name = {};    ///< `SpiBus`, in namespace finemote
  std::string_view header = {};  ///< `<finemote/spi.hpp>`
  bool starts = true;            ///< has start(), called once before the scheduler runs
  bool supervised = false;       ///< has supervise(), which the fastest bucket runs first
};

/// The class of the runtime through which a device asks for its transfers.
struct SlotClass {
  std::string_view name = {};      ///< `SpiSlot`, in namespace finemote
  bool takes_mode = false;         ///< the clock mode of the part, where it is not the usual one
  bool takes_route = false;        ///< the mux channel to set before each transfer
  bool takes_identifiers = false;  ///< of the frames that the part sends, and of one that several are commanded by
};

struct BusType {
  /// Whether a bus of the kind names a port of the board.
  enum class PortNeed { always, where_there_is_one, never };

  /// What the channels of a bus are.
  enum class Channels {
    none,
    outputs,  ///< of pulses: a part can be put on another one
    selects,  ///< chip selects: each is wired to its part
    pins,     ///< the named pins of the board, in the order of its file
  };

  /// What the constructor of a device takes.
  enum class Reach {
    slot,     ///< its slot on the bus
    bus,      ///< the bus
    channel,  ///< a value that stands for an output of the bus
    pin,      ///< a value that stands for a pin
    nothing,
  };

  /// Bytes that the driver takes in one request, where it does not take any number.
  struct Longest {
    std::optional<std::int64_t> written, read;
    bool with_dma = false;  ///< only on a port with DMA, of bytes that it does not reach
  };

  /// What goes out after the devices of a bucket have written.
  enum class Flush {
    nothing,        ///< everything went out when the devices wrote it
    outputs,        ///< the values of all outputs
    shared_frames,  ///< frames that several devices fill
  };

  BusKind kind = {};
  std::string_view name = {};  ///< `type=` of `<bus>`; `buses` of board files, `types` of descriptors

  // The port and its rate
  PortNeed port_need = PortNeed::always;
  std::optional<PortClass> port_class = {};  ///< none: boards have no object for such a port
  BusRate rate = {};

  // Which devices there can be, and what tells one from another
  bool is_for_one = false;                        ///< connects two ends: one device
  bool has_addresses = false;                     ///< a part answers to its address: no two may have the same
  Channels channels = Channels::none;             ///< each belongs to one device
  std::optional<std::size_t> most_devices = 255;  ///< that the driver serves, which counts them in a byte; none: any
  std::size_t most_shared_frames = 0;             ///< that the driver keeps
  bool carries_expanders = false;  ///< an expander can sit on it, and the channels of a mux are buses of the kind
  bool is_shared = false;  ///< parts can move from one bus of the kind to another without other pins of their own

  // The line
  bool has_line_format = false;  ///< it is started with the format that its device states, inverted or not
  bool has_direction = false;    ///< several parts send on one line, each through a line driver that is switched on
  bool has_two_lines = false;    ///< what a part sends by itself meets nothing that is sent to it
  bool is_arbitrated = false;    ///< identifiers decide what goes first
  bool is_polled = false;        ///< nothing but a look of a job carries it on: the next transfer begins with one
  bool is_mastered = false;      ///< nothing happens that no device begins
  bool is_both_ways = false;     ///< what is sent brings as many bytes
  bool takes_then = false;       ///< the driver takes what is written after an exchange with it, in one request
  Longest longest = {};
  bool counts_traffic = false;  ///< its interrupts are known to belong to what devices ask for, and parts declare

  /// Time on the wire and service routines of an exchange in one unit, without the one that begins it on an idle bus;
  /// null: a kind without frames. Throws Overflow.
  WireUnit (*unit)(const BusExchange& exchange) = nullptr;

  /// Bits from the end of what came before to the end of the shortest frame that holds this many bytes; null: a kind
  /// whose frames are not told apart.
  std::int64_t (*least_bits)(std::int64_t bytes) = nullptr;

  // Generated code
  Flush flush = Flush::nothing;
  Reach reach = Reach::nothing;
  BusClass bus_class = {};
  SlotClass slot_class = {};  ///< where devices reach the bus by a slot
};

const BusType& bus_type(BusKind kind);

/// The kind that carries expanders.
const BusType& expander_bus_type();

/// All kinds, in the order of the reference.
std::span<const BusType* const> bus_types();

}  // namespace finemote::gen
