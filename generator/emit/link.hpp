// What a device's link to a computer carries, and how: the table in its tree, and a header for the computer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/link_fields.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/command_frame.hpp"
#include "generator/emit/constants.hpp"
#include "generator/emit/names.hpp"

namespace finemote::gen {

/// The state or command of one device.
struct LinkItem {
  std::string name;        ///< C++ name of the device
  std::string interface;   ///< `Imu`; empty: known by its Stamp alone
  std::string expression;  ///< from inside `ports` of the link's tree
  std::vector<LinkField> fields;
  unsigned block = 0;  ///< of the frames it goes in
};

struct DeviceLink {
  DeviceId device;
  std::vector<LinkItem> up, down;
  unsigned up_blocks = 0, down_blocks = 0;
  std::uint32_t number = 0;  ///< a layout that differs in anything has another one
};

/// Every link of the robot, in schedule order. `interfaces` are the shipped ones.
/// Reports FM3205 when a state or command does not fit a frame, the commands do not fit one together, or states fill
/// more than sixteen.
std::vector<DeviceLink> plan_links(const Plan& plan, const InterfaceTable& interfaces, Diagnostics& diagnostics);

/// What a computer sends down the link; none where no device takes commands from it.
std::optional<CommandFrame> command_frame(const DeviceLink& link);

/// `host_layout` and the tables behind it, for the tree of the device: templates/link_layout.mustache.
Constant link_constant(const Plan& plan, const DeviceLink& link);

/// Template data of host/<device>_link.hpp.
Data link_header(const Plan& plan, const DeviceLink& link);

/// `host/<device>_link.hpp` for every link, in schedule order.
std::vector<std::string> link_header_names(const Robot& robot, const Forest& forest);

}  // namespace finemote::gen
