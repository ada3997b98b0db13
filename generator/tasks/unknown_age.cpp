#include "generator/tasks/unknown_age.hpp"

#include <algorithm>
#include <map>

#include "generator/bus/bus_type.hpp"
#include "generator/model/connection.hpp"
#include "generator/tasks/frame_units.hpp"

namespace finemote::gen::timing {
namespace {

/// Something of the part comes to the device.
bool brings(const Frame& frame) { return frame.read_bytes > 0 || frame.stage == FrameStage::autonomous; }

/// Null: it measures nothing itself.
const NamedPin* measured_pin(const Use& use) {
  return use.spec->function == "analog" && use.named != nullptr ? use.named : nullptr;
}

/// An edge is of the past when it is read, as is what a converter measured.
bool reads_past_of_pins(const gen::Device& device) {
  return std::any_of(device.uses.begin(), device.uses.end(), [](const Use& use) {
    return measured_pin(use) != nullptr || (use.spec->function == "interrupt" && use.named != nullptr);
  });
}

/// Where what is sent brings as much, it may be questions.
bool asks_both_ways(const Robot& robot, const gen::Device& device) {
  const std::vector<Connection> connections = connections_of(device);
  return std::any_of(connections.begin(), connections.end(), [&](const Connection& connection) {
    const BusKind kind = robot.segments[connection.segment].bus_kind;
    return bus_type(kind).is_both_ways && turns_of(frame_units(frames_over(device, connection), kind)) > 0;
  });
}

/// What a part sends, what a converter measured, and when an edge came, goes into the state that others see some time
/// after it was so.
bool has_no_acquisition(const Robot& robot, const gen::Device& device) {
  const DeviceType& type = *device.type;
  const std::vector<Frame> frames = type.frames.value_or(std::vector<Frame>());
  const bool is_late =
      std::any_of(frames.begin(), frames.end(), brings) || reads_past_of_pins(device) || asks_both_ways(robot, device);
  return !type.acquisition && (!type.provides.empty() || type.actuator) && is_late;
}

/// A conversion that is under way when another input of the same converter is to be measured keeps that one waiting.
bool shares_converter(const Robot& robot, const gen::Device& device) {
  std::map<std::string, int> inputs;  // by converter
  for (const gen::Device& other : robot.devices) {
    for (const Use& use : other.uses) {
      if (const NamedPin* pin = measured_pin(use)) ++inputs[pin->converter];
    }
  }
  return std::any_of(device.uses.begin(), device.uses.end(), [&](const Use& use) {
    const NamedPin* pin = measured_pin(use);
    return pin != nullptr && inputs[pin->converter] > 1;
  });
}

/// A driver takes one request of a device at a time, and nothing lets one end within a job: with more of them in a job,
/// one that measures may have to leave out its turn.
bool may_find_slot_busy(const Robot& robot, const gen::Device& device) {
  const DeviceType& type = *device.type;
  if (!type.acquisition || type.acquisition->published_every > 1) return false;
  const std::vector<Connection> connections = connections_of(device);
  return std::any_of(connections.begin(), connections.end(), [&](const Connection& connection) {
    const BusKind kind = robot.segments[connection.segment].bus_kind;
    if (bus_type(kind).unit == nullptr) return false;
    const std::vector<FrameUnit> units = frame_units(frames_over(device, connection), kind);
    return turns_of(units) > 1 &&
           std::any_of(units.begin(), units.end(), [](const FrameUnit& unit) { return unit.is_asked() && unit.reads; });
  });
}

/// Its type says that it is asked, and its part may send measurements by itself.
bool is_sent_by_itself(const Robot& robot, const gen::Device& device) {
  const DeviceType& type = *device.type;
  if (!type.acquisition || type.acquisition->model != gen::Acquisition::Model::polled || measures_pins(device))
    return false;
  bool is_asked = false;
  for (const Connection& connection : connections_of(device)) {
    const std::vector<Frame> frames = frames_over(device, connection);
    if (std::any_of(frames.begin(), frames.end(),
                    [](const Frame& frame) { return frame.stage == FrameStage::autonomous && frame.has_sample; }))
      return true;
    const std::vector<FrameUnit> units = frame_units(frames, robot.segments[connection.segment].bus_kind);
    is_asked = is_asked || std::any_of(units.begin(), units.end(),
                                       [](const FrameUnit& unit) { return unit.is_asked() && unit.reads; });
  }
  return !is_asked && std::any_of(type.interrupts.begin(), type.interrupts.end(),
                                  [](const Interrupt& entry) { return entry.is_autonomous && !entry.use.empty(); });
}

}  // namespace

bool measures_pins(const gen::Device& device) {
  return std::any_of(device.uses.begin(), device.uses.end(),
                     [](const Use& use) { return measured_pin(use) != nullptr; });
}

UnknownAge unknown_age(const Robot& robot, const gen::Device& device) {
  if (device.type == nullptr) return UnknownAge::none;
  if (has_no_acquisition(robot, device)) return UnknownAge::no_acquisition;
  if (is_sent_by_itself(robot, device)) return UnknownAge::sent_by_itself;
  if (shares_converter(robot, device)) return UnknownAge::shared_converter;
  return may_find_slot_busy(robot, device) ? UnknownAge::busy_slot : UnknownAge::none;
}

}  // namespace finemote::gen::timing
