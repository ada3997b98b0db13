#include "generator/lint/type_rules.hpp"

#include <fmt/format.h>

namespace finemote::gen {

void find_half_actuators(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  const DeviceType& type = *device.type;
  if (type.builtin) return;  // bmi088: it has to be made safe, and needs no commands
  if (type.actuator && !type.provides.empty() && !type.has_command()) {
    findings
        .add(device, fmt::format("device '{}' is an actuator, and its type '{}' takes no commands", device.name.text,
                                 type.name))
        .note("what its parent or a computer sends to it goes nowhere")
        .hint(fmt::format("\"command\": true beside the interface in \"provides\" of '{}', and a member 'command'",
                          type.display_path));
  }
  if (!type.actuator && type.has_command() && device.segment) {
    findings
        .add(device, fmt::format("device '{}' takes commands and sits on a bus, and its type '{}' is no actuator",
                                 device.name.text, type.name))
        .note("nobody makes it safe: where the firmware stops, it goes on with its last command")
        .hint(fmt::format("\"actuator\": true in '{}', and a member function 'safe()'", type.display_path));
  }
}

}  // namespace finemote::gen
