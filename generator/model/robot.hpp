// The robot as its file describes it, checked and resolved: what every later stage starts from.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/device_type.hpp"
#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// A name as written and as C++ writes it (DESIGN 2, Names).
struct Name {
  std::string text;  ///< `baro-1`
  std::string cpp;   ///< `baro_1`
};

/// A param with its value: as given, or the descriptor's default.
struct Param {
  const ParamSpec* spec = nullptr;
  ParamValue value;
  bool given = false;
};

struct Pose {
  std::array<double, 3> xyz{};  ///< [m]
  std::array<double, 3> rpy{};  ///< [rad]
};

/// A joint of the URDF, as urdfdom accepted it.
struct Joint {
  std::string name;
  std::string type;  ///< revolute, continuous, prismatic, fixed, floating, planar
  std::string parent_link, child_link;
  Pose origin;
  std::array<double, 3> axis{1, 0, 0};
  std::optional<double> lower, upper, effort, velocity;
  std::optional<double> damping, friction;
  std::string mimic;  ///< the joint whose angle it takes over; empty: it moves by itself
  Position at;
};

/// Mass of a link and how it is spread.
struct Inertial {
  Pose origin;                      ///< centre of mass and axes of `inertia`, in the link's frame
  double mass = 0;                  ///< [kg]
  std::array<double, 6> inertia{};  ///< xx xy xz yy yz zz [kg m^2]
};

struct Link {
  std::string name;
  Position at;
  std::optional<Inertial> inertial;
};

/// A bus at a port of the board.
struct Bus {
  Name name;
  BusKind kind = BusKind::uart;
  std::string port;                         ///< chip name; empty for virtual
  std::int64_t rate = 0;                    ///< baud [bit/s], clock [Hz] or bitrate [bit/s]; 0 where the kind has none
  std::optional<std::int64_t> isr_wcet_ns;  ///< as given
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
  enum class Model { tca9548a, pca9685 };
  struct Channel {
    std::uint32_t index = 0;
    Name name;  ///< of the i2c bus it is
    Position at;
  };
  Name name;
  Model model = Model::tca9548a;
  const ExpanderType* type = nullptr;
  std::size_t segment = 0;  ///< the bus it sits on, as an index into Robot::segments
  std::uint32_t address = 0;
  std::vector<Channel> channels;  ///< tca9548a
  std::vector<Param> params;
  Position at;
};

/// Anything `bus=` can name: a physical bus, one channel of a mux, or a PWM expander.
struct Segment {
  enum class Kind { bus, mux_channel, pwm_expander };
  Kind kind = Kind::bus;
  Name name;
  BusKind bus_kind = BusKind::uart;     ///< what a device sees
  std::size_t bus = 0;                  ///< the physical bus: index into Robot::buses
  std::optional<std::size_t> expander;  ///< index into Robot::expanders, for the two other kinds
  std::uint32_t channel = 0;            ///< of the mux
};

/// `<use>`: further hardware of a device.
struct Use {
  const UseSpec* spec = nullptr;
  std::optional<std::size_t> segment;
  std::string pin;                  ///< of the chip: `PA0`
  const NamedPin* named = nullptr;  ///< what the board file says of it; null: nothing
  std::optional<std::uint32_t> channel;
  Position at;
};

/// `<reads>`: an observed device outside the own subtree.
struct Read {
  std::size_t device = 0;  ///< index into Robot::devices
  std::size_t role = 0;    ///< index into the reader's DeviceType::roles
  Position at;
};

struct Wcet {
  enum class Source { assumed, budget, measured, static_analysis };
  std::int64_t update_ns = 0;
  std::int64_t handle_ns = 0;
  Source source = Source::assumed;
};

/// One child of a device, by role.
struct ChildRef {
  std::size_t device = 0;  ///< index into Robot::devices
  std::size_t role = 0;    ///< index into the parent's DeviceType::roles
};

struct Device {
  Name name;
  const DeviceType* type = nullptr;
  std::optional<std::size_t> parent;  ///< index into Robot::devices; none: a root
  std::optional<std::size_t> role;    ///< index into the parent's roles
  std::int64_t period_ns = 0;
  std::optional<std::size_t> segment;  ///< index into Robot::segments; none: composite or virtual
  std::optional<std::uint32_t> address, channel, id;
  std::string link, joint;    ///< empty: none
  std::vector<Param> params;  ///< in DeviceType::params order, complete
  std::vector<Use> uses;
  std::vector<Read> reads;            ///< document order
  std::vector<std::size_t> children;  ///< indices, in document order of start tags (nested and `parent=` together)
  Wcet wcet;
  Position at;  ///< start tag
  Position period_at;
};

struct Requirement {
  enum class Kind { latency_end_to_end, latency_decision, utilization, jitter };
  Kind kind = Kind::latency_end_to_end;
  std::string text;                   ///< the operand as written: `imu -> thrusters`
  std::vector<std::size_t> from, to;  ///< latency: devices (a role names several); jitter: `to` holds one
  std::optional<std::size_t> bus;     ///< utilization of a physical bus; none: the cpu
  std::int64_t max_ns = 0;            ///< latency, jitter
  double max_fraction = 0;            ///< utilization, 0..1
  std::string max_text;               ///< as written
  Position at;
};

/// A descriptor or board file that was found, and is read when something names it.
struct LibraryFile {
  std::string name;     ///< its name without `.json`: the type or board it has to describe
  std::string path;     ///< to open it
  std::string display;  ///< `builtin:devices/ms5837.json`, or relative to the input
  bool builtin = true;
  bool failed = false;  ///< it was read and is wrong, which was reported
};

/// Descriptors and board files that were found and, of these, loaded; owns what the robot points at.
struct Library {
  std::vector<LibraryFile> device_files;  ///< sorted by name
  std::vector<LibraryFile> board_files;
  std::vector<LibraryFile> expander_files;
  std::string schema_dir;  ///< where the JSON Schemas are
  std::vector<std::unique_ptr<DeviceType>> device_types;
  std::vector<std::unique_ptr<Board>> boards;
  std::vector<std::unique_ptr<ExpanderType>> expander_types;

  [[nodiscard]] const DeviceType* device_type(std::string_view name) const {
    for (const auto& t : device_types) {
      if (t->name == name) return t.get();
    }
    return nullptr;
  }
  [[nodiscard]] const Board* board(std::string_view name) const {
    for (const auto& b : boards) {
      if (b->name == name) return b.get();
    }
    return nullptr;
  }
};

struct Robot {
  Name name;
  const Board* board = nullptr;
  std::vector<Param> board_params;
  std::int64_t tick_ns = 1'000'000;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Bus> buses;           ///< document order
  std::vector<Expander> expanders;  ///< document order
  std::vector<Segment> segments;    ///< buses first, then channels and PWM expanders in document order
  std::vector<Device> devices;      ///< document order of start tags
  std::vector<Requirement> requirements;
  std::vector<std::string> inputs;       ///< display names of every file read: input, includes, descriptors, board
  std::vector<std::string> input_paths;  ///< the same files as opened, for hashes and depfiles
  std::string source;                    ///< display name of IN
};

}  // namespace finemote::gen
