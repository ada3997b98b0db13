// What every part of the model reader works on: the tags, what they were resolved to so far, and where to complain.
#pragma once

#include <optional>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/build.hpp"
#include "generator/model/robot.hpp"
#include "generator/model/tags.hpp"
#include "generator/urdf/urdf.hpp"

namespace finemote::gen {

class Mechanism;

/// The robot being built, with the tag of each part. The parts run in the order of build.cpp; each may rely on what
/// earlier ones resolved, and skips what they could not (that was reported).
struct Reading {
  const xml::Node& root;
  Library& library;
  const ModelOptions& options;
  Sources& sources;
  Diagnostics& diagnostics;

  Tags tags;
  Kinematics kinematics;
  Robot robot;

  bool tick_is_known = false;

  /// Beside Robot::buses, Robot::expanders and Robot::devices, with the same indices as the lists of tags.
  struct BusState {
    bool kind_is_known = false;
    const Port* port = nullptr;  ///< null: none, or a mistake
    bool rate_is_known = false;
  };
  Table<BusId, BusState> buses;

  struct DeviceState {
    bool parent_is_wrong = false;  ///< a mistake in `parent`: neither root nor child
    bool role_is_wrong = false;
    bool joint_is_wrong = false;  ///< a mistake in `joint`, reported
    bool bus_is_wrong = false;
    bool period_is_wrong = false;  ///< a mistake in `period`, here or where it is inherited from
    bool in_cycle = false;
    bool is_incomplete = false;  ///< a child is of unknown type or role: counting its children says nothing
  };
  Table<DeviceId, DeviceState> devices;

  [[nodiscard]] std::optional<DeviceId> device_named(std::string_view name) const;
  [[nodiscard]] std::optional<SegmentId> segment_named(std::string_view name) const;
  /// FM3019, unless the bus is missing because of another mistake. `fitting` are the buses that would do here.
  void report_unknown_bus(const xml::Attribute& name, const std::vector<std::string>& fitting);
  [[nodiscard]] std::vector<std::string> device_names() const;
  [[nodiscard]] std::vector<std::string> segment_names() const;
  /// Of the buses of these kinds.
  [[nodiscard]] std::vector<std::string> segment_names(const std::vector<BusKind>& kinds) const;
  /// False where the type of the bus is a mistake.
  [[nodiscard]] bool kind_is_known(const Segment& segment) const;
  [[nodiscard]] const xml::Node& device_tag(DeviceId device) const { return *tags.devices[device].node; }
};

// The parts, in order. Each header comment of the .cpp of the same name says what it reports.
void read_board_tag(Reading& reading);                       // board_tag.cpp
void read_buses(Reading& reading);                           // buses.cpp
void read_expanders(Reading& reading);                       // expanders.cpp
void read_devices(Reading& reading);                         // devices.cpp: what each device says of itself
void check_headers(Reading& reading);                        // headers.cpp
void check_names(Reading& reading);                          // name_check.cpp
void resolve_parents(Reading& reading);                      // parents.cpp: the forest and inherited periods
void resolve_roles(Reading& reading);                        // roles.cpp: children and reads to roles
void resolve_places(Reading& reading);                       // places.cpp: address, channel, id
void check_resources(Reading& reading);                      // resources.cpp: ports, pins, DMA streams
void check_driver_limits(Reading& reading);                  // driver_limits.cpp: inverters, frames, numbers of devices
void check_pulses(Reading& reading);                         // pulses.cpp: what fits between two pulses
void check_arities(Reading& reading);                        // arity.cpp: how many children each role has
void judge_doubts(Reading& reading);                         // doubts.cpp: words of the URDF that are skipped
void check_joints(Reading& reading);                         // joints.cpp
void check_geometry(Reading& reading, DeviceId device);      // geometry.cpp: of check_joints(), for one device
void report_no_position(Reading& reading, DeviceId device);  // joints.cpp: limits of its joint with nothing between
void read_ros_joints(Reading& reading);                      // ros_joints.cpp: what ROS commands
void read_requirements(Reading& reading);                    // requirements.cpp

bool satisfies(const DeviceType& child, const RoleSpec& role);         // roles.cpp: it provides the role's interface
bool is_descendant(const Robot& robot, DeviceId device, DeviceId of);  // roles.cpp: below it, or itself

/// Nothing that was reported changes where this link is (doubts.cpp).
bool is_place_known(const Reading& reading, const Mechanism& mechanism, const std::string& link);

/// Channels of a segment: an expander's, those of a PWM port, pins; 0: none, or not known (channels.cpp).
std::uint32_t channel_count(const Reading& reading, SegmentId segment);
/// Those of `count` channels of a segment that no device uses (channels.cpp).
std::vector<std::uint32_t> free_channels(const Reading& reading, SegmentId segment, std::uint32_t count);
/// Ids of the type that clash with no device on the segment's bus, the first 16 (ids.cpp).
std::vector<std::uint32_t> free_ids(const Reading& reading, const DeviceType& type, SegmentId segment);

/// Reads `period` of a device, unless it is inherited (periods.cpp).
void read_period(Reading& reading, const xml::Node& tag, Device& device, Reading::DeviceState& state);
/// Reads the `<use>` elements of a device whose type is known (uses.cpp).
void read_uses(Reading& reading, const xml::Node& tag, Device& device);
bool contains(const std::vector<BusKind>& kinds, BusKind kind);  // devices.cpp

/// The tag of a device's `<use>` (places.cpp).
const xml::Node& use_tag(const Reading& reading, DeviceId device, const Use& use);

/// Joints for a child `child` in a role of `parent` whose geometry is computed: they fit, and no device drives them.
/// Those named like the child or its siblings; without any all that fit, unless `only_alike` (joint_offers.cpp).
std::vector<std::string> offered_joints(const Reading& reading, const Device& parent, const std::string& role,
                                        const std::string& child, bool only_alike);

/// Reads the `<param>` children of a tag by their specs; the result is complete, in the order of the specs. `owner`
/// is how messages call it: `device 'imu'`.
std::vector<Param> read_param_tags(Reading& reading, const xml::Node& tag, const std::vector<ParamSpec>& specs,
                                   const std::string& owner);  // param_tags.cpp

}  // namespace finemote::gen
