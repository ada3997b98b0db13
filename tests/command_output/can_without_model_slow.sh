# A device on CAN without a model: a node in its place acknowledges, so that nothing is sent twice.
mkdir devices
cat >devices/axis.hpp <<'X'
#pragma once
#include <finemote/can.hpp>
#include <finemote/contract.hpp>
struct Axis {
  constexpr explicit Axis(finemote::CanSlot& slot) : slot_(&slot) {}
  void update() {}
  void handle() { send(1); }
  void safe() { send(0); }
  finemote::Stamp state;

 private:
  void send(std::uint8_t value) {
    finemote::CanFrame frame{};
    frame.id = slot_->id();
    frame.size = 4;
    frame.data[0] = value;
    static_cast<void>(slot_->send(frame));
  }
  finemote::CanSlot* const slot_;
};
X
cat >devices/axis.json <<'X'
{ "schema": "finemote.device/1", "type": "axis", "summary": "sends four bytes", "class": "Axis", "header": "axis.hpp",
  "bus": { "types": ["can"], "id": { "min": 1, "max": 63 } }, "provides": [], "actuator": true,
  "frames": [{ "stage": "handle", "write": 4 }], "wcet": { "update_ns": 5000, "handle_ns": 9000 } }
X
robot <<'X'
    <bus name="can" type="can" port="can1"/>
    <device name="axis" type="axis" bus="can" id="1" period="5ms"/>
    <device name="axis.node" type="axis" bus="can" id="2" period="5ms"/>
X
finemote run robot.urdf --duration 100ms >text
echo "exit $?"
sed -n 1,2p text
grep "transfers" text | sed 's/ *busy.*//'
