mkdir devices
cat >devices/winch.hpp <<'H'
#pragma once
#include <finemote/can.hpp>
#include <finemote/interfaces/motor.hpp>
class Winch {
 public:
  constexpr explicit Winch(finemote::CanSlot&) {}
  void update() {}
  void handle() {}
  void safe() {}
  finemote::MotorState state;
  finemote::MotorCommand command;
};
H
descriptor() {
  cat >devices/winch.json <<J
{ "schema": "finemote.device/1", "type": "winch", "summary": "a winch on CAN", "class": "Winch", "header": "winch.hpp",
  "bus": { "types": ["can"] }, "provides": [{ "interface": "Motor"$1 }], "frames": [{ "stage": "handle", "write": 8 }]$2 }
J
}
robot <<'X'
    <bus name="deck" type="can" port="can1" bitrate="1Mbit/s"/>
    <device name="drum" type="winch" bus="deck" period="10ms">
      <wcet update="5us" handle="10us" source="budget"/>
    </device>
X
descriptor '' ', "actuator": true'
finemote lint robot.urdf
descriptor ', "command": true' ''
finemote lint robot.urdf
descriptor ', "command": true' ', "actuator": true'
finemote lint robot.urdf
