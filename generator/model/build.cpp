#include "generator/model/build.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/descriptor/library.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/names.hpp"
#include "generator/model/reading.hpp"
#include "generator/model/streamed_frames.hpp"

namespace finemote::gen {

std::optional<DeviceId> Reading::device_named(std::string_view name) const {
  for (const DeviceId device : robot.devices.ids()) {
    if (robot.devices[device].name.text == name) return device;
  }
  return {};
}

std::optional<SegmentId> Reading::segment_named(std::string_view name) const {
  for (const SegmentId segment : robot.segments.ids()) {
    if (robot.segments[segment].name.text == name) return segment;
  }
  return {};
}

void Reading::report_unknown_bus(const xml::Attribute& name, const std::vector<std::string>& fitting) {
  const auto& lost = tags.lost_buses;
  if (std::find(lost.begin(), lost.end(), name.value) != lost.end()) return;
  suggest(at_value(diagnostics, code::unknown_bus, name, fmt::format("there is no bus '{}'", name.value)), name.value,
          fitting);
}

std::vector<std::string> Reading::device_names() const {
  std::vector<std::string> names;
  for (const Device& device : robot.devices) names.push_back(device.name.text);
  return names;
}

std::vector<std::string> Reading::segment_names() const {
  std::vector<std::string> names;
  for (const Segment& segment : robot.segments) names.push_back(segment.name.text);
  return names;
}

std::vector<std::string> Reading::segment_names(const std::vector<BusKind>& kinds) const {
  std::vector<std::string> names;
  for (const Segment& segment : robot.segments) {
    if (contains(kinds, segment.bus_kind)) names.push_back(segment.name.text);
  }
  return names;
}

bool Reading::kind_is_known(const Segment& segment) const {
  return segment.kind != Segment::Kind::bus || buses[segment.bus].kind_is_known;
}

namespace {

constexpr std::string_view kVersion = "1";

bool check_root(const xml::Node& root, Diagnostics& diagnostics) {
  if (!root.is_element("robot")) {
    at_tag(diagnostics, code::not_a_robot, root, fmt::format("the root element is <{}>, not <robot>", root.name))
        .hint("a URDF begins <robot name=\"...\">");
    return false;
  }
  if (root.attribute("name") != nullptr) return true;
  at_tag(diagnostics, code::not_a_robot, root, "the robot has no 'name'")
      .hint("write <robot name=\"...\">: generated code is in a namespace of that name");
  return false;
}

/// A version this tool does not read: nothing below can be judged.
bool check_version(const xml::Node& root, Diagnostics& diagnostics) {
  bool is_known = true;
  for (const xml::Node& block : root.children) {
    const xml::Attribute* version = block.is_element("finemote") ? block.attribute("version") : nullptr;
    if (version == nullptr || version->value == kVersion) continue;
    is_known = false;
    at_value(diagnostics, code::version_unknown, *version,
             fmt::format("version '{}' of the extension is unknown", version->value))
        .note(fmt::format("this tool reads version {}", kVersion))
        .hint(fmt::format("write version=\"{}\"", kVersion));
  }
  return is_known;
}

void check_version_is_given(const Tags& tags, Diagnostics& diagnostics) {
  for (const xml::Node* block : tags.blocks) {
    if (block->attribute("version") != nullptr || tags.is_misspelt(*block, "version")) return;
  }
  at_tag(diagnostics, code::version_missing, *tags.blocks.front(), "no <finemote> element has a version")
      .hint(fmt::format("write <finemote version=\"{}\">", kVersion));
}

void report_no_extension(const xml::Node& root, Diagnostics& diagnostics) {
  at_tag(diagnostics, code::no_extension, root, "the robot has no <finemote> element")
      .note("it describes the robot's board, buses and devices; ROS tools ignore it")
      .hint("add inside <robot>: <finemote version=\"1\"><board name=\"robomaster_type_c\"/></finemote>");
}

/// Buses and boards alone are nothing to run: said when nothing else explains where the devices went.
void check_there_is_a_device(const Tags& tags, const Robot& robot, Diagnostics& diagnostics) {
  if (!robot.devices.empty()) return;
  at_tag(diagnostics, code::no_device, *tags.blocks.front(), "the robot has no device")
      .hint("add for example <device name=\"load\" type=\"sim_load\" period=\"10ms\"/>");
}

/// What a stage is assumed to take: `alone`, more for every child, and what some params say. Saturates: such a time
/// fails every analysis, which says so.
Duration assumed_stage(const Device& device, Duration alone, Duration per_child,
                       const std::vector<std::string>& params) {
  const auto children = static_cast<std::int64_t>(device.children.size() + device.reads.size());
  try {
    Duration sum = alone + per_child * children;
    for (const std::string& param : params) sum += nanoseconds(param_value(device.params, param, std::int64_t{0}));
    return sum;
  } catch (const Overflow&) {
    return Duration::max();
  }
}

/// Saturates, too.
Duration with_frames(const Robot& robot, const Device& device) {
  try {
    return device.wcet.update + most_frames(robot, device) * device.wcet.per_frame;
  } catch (const Overflow&) {
    return Duration::max();
  }
}

/// What a device without <wcet> is assumed to need: its type's default, or the tool's.
void assume_wcet(const Robot& robot, Device& device, Duration otherwise) {
  if (device.wcet.source != Wcet::Source::assumed) return;
  device.wcet.update = device.wcet.handle = otherwise;
  if (device.type == nullptr || !device.type->wcet) return;
  const WcetDefault& wcet = *device.type->wcet;
  device.wcet.update = assumed_stage(device, wcet.update, wcet.update_per_child, wcet.update_params);
  device.wcet.per_frame = wcet.per_frame;
  if (wcet.per_frame > Duration::zero()) device.wcet.update = with_frames(robot, device);
  device.wcet.handle = assumed_stage(device, wcet.handle, wcet.handle_per_child, wcet.handle_params);
}

void list_inputs(Robot& robot, const Sources& sources) {
  for (const SourceFile& file : sources.files()) {
    if (std::find(robot.inputs.begin(), robot.inputs.end(), file.name) != robot.inputs.end()) continue;
    robot.inputs.push_back(file.name);
    robot.input_paths.push_back(file.path);
  }
}

void read_all(Reading& reading) {
  read_board_tag(reading);
  read_buses(reading);
  read_expanders(reading);
  read_devices(reading);
  check_headers(reading);
  check_names(reading);
  resolve_parents(reading);
  resolve_roles(reading);
  resolve_places(reading);
  check_resources(reading);
  check_driver_limits(reading);
  check_pulses(reading);
  judge_doubts(reading);
  check_joints(reading);
  check_arities(reading);
  read_requirements(reading);
  read_ros_joints(reading);
}

}  // namespace

std::optional<Robot> build_model(const xml::Document& document, Library& library, const ModelOptions& options,
                                 Sources& sources, Diagnostics& diagnostics) {
  const std::size_t findings = diagnostics.size();
  const xml::Node& root = document.root;
  if (!check_root(root, diagnostics) || !check_version(root, diagnostics)) return {};
  Reading reading{
      root,
      library,
      options,
      sources,
      diagnostics,
      read_tags(root, options.from_xacro, expander_type_names(library),
                {[&] { return suggested_board(library, sources); }, [&] { return suggested_mux(library, sources); }},
                diagnostics),
      read_urdf(root, diagnostics),
      {},
      false,
      {},
      {}};
  if (reading.tags.has_xacro) return {};
  if (reading.tags.blocks.empty()) {
    if (diagnostics.size() == findings) report_no_extension(root, diagnostics);
    return {};
  }
  check_version_is_given(reading.tags, diagnostics);
  reading.robot.name = make_name(value_of(root, "name"));
  reading.robot.source = options.source;
  if (options.source.empty() && root.at.file != nullptr) reading.robot.source = root.at.file->name;
  read_all(reading);
  if (diagnostics.size() == findings) check_there_is_a_device(reading.tags, reading.robot, diagnostics);
  const bool is_right = diagnostics.size() == findings;
  for (const Doubt& doubt : reading.kinematics.doubts) diagnostics.add(doubt.finding);
  if (!is_right || reading.robot.board == nullptr) return {};
  reading.robot.links = reading.kinematics.links;
  reading.robot.joints = reading.kinematics.joints;
  for (Device& device : reading.robot.devices) assume_wcet(reading.robot, device, options.assumed_wcet);
  list_inputs(reading.robot, sources);
  return std::move(reading.robot);
}

}  // namespace finemote::gen
