// What a device type is, as its JSON descriptor says (`schemas/devices/<type>.json`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/acquisition.hpp"
#include "generator/descriptor/emulation.hpp"
#include "generator/descriptor/frames.hpp"
#include "generator/descriptor/identifiers.hpp"
#include "generator/descriptor/interrupts.hpp"
#include "generator/descriptor/link_fields.hpp"
#include "generator/descriptor/param.hpp"
#include "generator/diagnostic/source.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A C++ tag struct naming a State and, for actuators, a Command type; `any` stands for every interface.
struct Interface {
  std::string name;  ///< as in the descriptor: `Thruster`, `my::Gripper`, `any`
  std::string cpp;   ///< qualified: `finemote::Thruster`
  bool has_command = false;
  std::string state = "state";      ///< data member of the device holding the State
  std::string command = "command";  ///< and the Command
  InterfaceFields fields;           ///< what a link carries of them; none: as `schemas/interfaces.json` says
};

struct RoleSpec {
  std::string name;
  std::string interface;  ///< Interface::name, or `any`
  std::uint32_t min = 0;
  std::optional<std::uint32_t> max;  ///< none: unbounded
  bool passes = true;                ///< what its children measure becomes part of the commands the device sends
  std::string summary;
};

/// The SPI clock mode of parts whose descriptor names none, as finemote::SpiSlot takes it by itself.
inline constexpr std::uint32_t kUsualSpiMode = 3;

/// As UseSpec::data_ready_of: the line is that of the part on the device's own bus.
constexpr std::string_view kDeviceItself = "device";

/// Further hardware of a device, named by `<use role=...>`.
struct UseSpec {
  std::string role;
  std::vector<BusKind> buses;
  bool required = false;
  std::string format = "8N1";             ///< uart
  std::string function;                   ///< gpio: what it does with the pin: input, output, interrupt or analog
  std::optional<std::uint32_t> spi_mode;  ///< none: that of the device
  std::string data_ready_of;  ///< interrupt: the use whose part's data-ready line this is, `device`: its own; or empty
  std::string summary;
};

/// What of the URDF the device needs; the emitter knows kinds, never robots.
struct GeometrySpec {
  std::string kind;                   ///< `allocation`, `rolling`, `chain`, `axes`, `mount`, `range`
  std::string role;                   ///< whose children it speaks of; empty where it speaks of the device itself
  bool optional = false;              ///< none without joints: the constructor gets a null pointer
  std::vector<std::string> replaces;  ///< params that say nothing where it is computed
  double tolerance_deg = 1;           ///< how far a direction may be off
  std::vector<std::string> commands;  ///< allocation: axes of the wrench it commands; empty: all
  std::string along;                  ///< axes, range: `x`, `y` or `z`, which the joints turn about; empty: any
  std::string behind;                 ///< axes: the role whose joint carries these; empty: none
  std::string param;            ///< rolling: radius of a wheel [m]; range: angle between the ends [rad]; chain: share
                                ///< of the weight that is carried
  std::string carries;          ///< axes: the role whose sensor is behind the last of them; empty: none
  std::string lowest, highest;  ///< range of a role: params that narrow it [rad]; empty: none
};

/// What the descriptor calls the `param` of a kind: `radius`, `travel` or `share`.
const char* param_member(const std::string& kind);

/// Assumed execution time of a device without `<wcet>`: fixed part, values of params, and a part per child.
struct WcetDefault {
  Duration update;
  Duration handle;
  std::vector<std::string> update_params, handle_params;  ///< names of params of unit time
  Duration update_per_child, handle_per_child;
  Duration per_frame;  ///< of update(): for every frame that the part sent by itself since the one before
};

struct DeviceType {
  std::string name;  ///< the `type` attribute: `ms5837`
  std::string summary;
  std::string cpp_class;     ///< `finemote::Ms5837`
  std::string header;        ///< as the descriptor names it, relative to its file
  std::string include;       ///< as generated code includes it: `finemote/devices/ms5837.hpp`, `my_sensor.hpp`
  std::string include_dir;   ///< folder to add to the include path for a user's type; empty for shipped types
  std::string display_path;  ///< `builtin:devices/ms5837.json`, or relative to the input
  bool builtin = true;
  bool has_mistakes = false;   ///< in its descriptor, which were reported
  std::vector<BusKind> buses;  ///< kinds of bus it can sit on; empty: composite or virtual
  bool bus_required = false;
  bool needs_address = false, needs_channel = false, needs_id = false;
  std::optional<std::uint32_t> default_address;
  std::vector<std::uint32_t> addresses;  ///< allowed ones; empty: any
  std::optional<std::uint32_t> id_min, id_max;
  std::optional<std::uint32_t> channel_min, channel_max;
  std::vector<Identifiers> receives;         ///< can: of its own frames, in the order its driver knows them by
  std::string format = "8N1";                ///< uart
  std::vector<std::int64_t> rates;           ///< uart, rs485, can: what the part can be set to; empty: any
  std::optional<std::int64_t> max_clock_hz;  ///< i2c, spi
  bool tunes = false;                        ///< pwm: it changes how often its output repeats
  std::uint32_t spi_mode = kUsualSpiMode;    ///< clock mode: CPOL * 2 + CPHA
  std::vector<Interface> provides;           ///< first one is the default
  std::vector<RoleSpec> roles;               ///< constructor order
  std::vector<UseSpec> uses;
  std::vector<ParamSpec> params;  ///< members of Config, by name
  std::vector<GeometrySpec> geometry;
  std::string link_role;  ///< whose states and commands go over its link; empty: it is none
  bool actuator = false;
  Duration bring_up;  ///< of what measures nothing: until its part obeys commands, at most
  bool constant_init = true;
  std::optional<WcetDefault> wcet;
  std::optional<Acquisition> acquisition;    ///< none: update() makes or reads its sample on the spot
  std::optional<std::vector<Frame>> frames;  ///< none: it may send anything
  std::vector<Interrupt> interrupts;
  Emulation emulation;

  /// can: the frame that it fills together with others when it has this id; none: it fills none.
  [[nodiscard]] std::optional<SharedFrame> shared_frame(std::uint32_t id) const;
  /// can: identifiers of its own frames when it has this id; 0 where a type has none.
  [[nodiscard]] std::vector<IdentifierRange> received(std::uint32_t id) const;
  /// How far the clock of the part may be off, both ways: all intervals of what it does by itself are by that clock.
  [[nodiscard]] std::int64_t clock_ppm() const { return acquisition ? acquisition->tolerance_ppm : kUsualTolerancePpm; }
  /// Frames over the bus of the use in that role; of no role: over the device's own. None: it declares none at all,
  /// too.
  [[nodiscard]] std::vector<Frame> frames_over(std::string_view role) const;
  /// Kinds of the bus that a frame goes over.
  [[nodiscard]] const std::vector<BusKind>& buses_of(const Frame& frame) const;
  /// Whether it is known how often the part sends such a frame by itself: as the frame says, else one for each sample.
  [[nodiscard]] bool says_interval_of(const Frame& frame) const;
  [[nodiscard]] bool has_command() const { return !provides.empty() && provides.front().has_command; }
};

}  // namespace finemote::gen
