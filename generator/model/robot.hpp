// The robot as its file describes it, checked and resolved: what every later stage starts from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/expander_type.hpp"
#include "generator/diagnostic/source.hpp"
#include "generator/index/ids.hpp"
#include "generator/model/computed_costs.hpp"
#include "generator/units/duration.hpp"
#include "generator/urdf/kinematics.hpp"

namespace finemote::gen {

/// A name as written and as C++ writes it (DESIGN 2, Names).
struct Name {
  std::string text;  ///< `baro-1`
  std::string cpp;   ///< `baro_1`
};

/// A bus at a port of the board.
struct Bus {
  Name name;
  BusKind kind = {};
  std::string port;                  ///< chip name; empty for virtual
  std::int64_t rate = 0;             ///< baud [bit/s], clock [Hz] or bitrate [bit/s]; 0 where the kind has none
  std::optional<Duration> isr_wcet;  ///< as given
  std::optional<std::int64_t> min_frame_bits;
  std::vector<Param> params;
  std::string driver_pin;                  ///< rs485: turns the line driver on; empty: it does so by itself
  const NamedPin* driver_named = nullptr;  ///< what the board file says of it
  Position driver_at;
  std::size_t driver_length = 0;  ///< of the pin's name as written
  Position at;
};

/// A part that provides buses and is no device.
struct Expander {
  struct Channel {
    std::uint32_t index = 0;
    Name name;  ///< of the i2c bus it is
    Position at;
  };
  Name name;
  const ExpanderType* type = nullptr;
  SegmentId segment;  ///< the bus it sits on
  std::uint32_t address = 0;
  std::vector<Channel> channels;  ///< of a mux
  std::vector<Param> params;
  Position at;
};

/// Anything `bus=` can name: a physical bus, one channel of a mux, or a PWM expander.
struct Segment {
  enum class Kind { bus, mux_channel, pwm_expander };
  Kind kind = Kind::bus;
  Name name;
  BusKind bus_kind = {};               ///< what a device sees
  BusId bus;                           ///< the physical one
  std::optional<ExpanderId> expander;  ///< for the two other kinds
  std::uint32_t channel = 0;           ///< of the mux
};

/// `<use>`: further hardware of a device.
struct Use {
  const UseSpec* spec = nullptr;
  std::optional<SegmentId> segment;
  std::string pin;                  ///< of the chip: `PA0`
  const NamedPin* named = nullptr;  ///< what the board file says of it; null: nothing
  std::optional<std::uint32_t> channel;
  Position at;
};

/// `<reads>`: an observed device outside the own subtree.
struct Read {
  DeviceId device;
  std::size_t role = 0;  ///< index into the reader's DeviceType::roles
  Position at;
};

struct Wcet {
  /// The type's default or the tool's; three that the tag declares; a bound of the robot's timing file.
  enum class Source { assumed, budget, measured, static_analysis, computed };
  Duration update;
  Duration handle;
  Source source = Source::assumed;
  Duration per_frame;                                    ///< assumed: the part of update() for each of most_frames()
  std::optional<Duration> update_static, handle_static;  ///< of the timing file, where it fits
  bool is_of_stale_file = false;                         ///< assumed: the figures of a stale timing file
  bool is_above_declared = false;                        ///< one of them is above what the tag declares
};

/// As the extension spells it: `static`. What it cannot spell is `computed`.
const char* to_string(Wcet::Source source);

struct Device {
  Name name;
  const DeviceType* type = nullptr;
  std::optional<DeviceId> parent;   ///< none: a root
  std::optional<std::size_t> role;  ///< index into the parent's roles
  Duration period;
  std::optional<SegmentId> segment;  ///< none: composite or virtual
  std::optional<std::uint32_t> address, channel, id;
  std::string link, joint;    ///< empty: none
  std::vector<Param> params;  ///< in DeviceType::params order, complete
  std::vector<Use> uses;
  std::vector<Read> reads;         ///< document order
  std::vector<DeviceId> children;  ///< document order of start tags (nested and `parent=` together)
  Wcet wcet;
  Position at;  ///< start tag
  Position period_at;
};

struct Requirement {
  enum class Kind { latency_end_to_end, latency_decision, utilization, jitter };
  Kind kind = Kind::latency_end_to_end;
  std::string text;                ///< the operand as written: `imu -> thrusters`
  std::vector<DeviceId> from, to;  ///< latency: devices (a role names several); jitter: `to` holds one
  std::optional<BusId> bus;        ///< utilization of a physical bus; none: the cpu
  Duration max;                    ///< latency, jitter
  double max_fraction = 0;         ///< utilization, 0..1
  std::string max_text;            ///< as written
  Position at;
};

/// A joint as <ros2_control> describes it.
struct RosJoint {
  std::string name;
  std::vector<std::string> commands;  ///< names of its command interfaces, in document order; empty: it takes none
  Position at;                        ///< its tag there
};

struct Robot {
  Name name;
  const Board* board = nullptr;
  std::vector<Param> board_params;
  Duration tick = milliseconds(1);
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<RosJoint> ros_joints;       ///< each once, in document order
  Table<BusId, Bus> buses;                ///< document order
  Table<ExpanderId, Expander> expanders;  ///< document order
  Table<SegmentId, Segment> segments;     ///< buses first, then channels and PWM expanders in document order
  Table<DeviceId, Device> devices;        ///< document order of start tags
  std::vector<Requirement> requirements;
  std::optional<ComputedCosts> computed;  ///< of the timing file
  std::vector<std::string> inputs;        ///< display names of every file read: input, includes, descriptors, board
  std::vector<std::string> input_paths;   ///< the same files as opened, for hashes and depfiles
  std::string source;                     ///< display name of IN

  /// The segment that is the bus itself.
  [[nodiscard]] static SegmentId segment_of(BusId bus) { return SegmentId{bus.value()}; }
};

}  // namespace finemote::gen
