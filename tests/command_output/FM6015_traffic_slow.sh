mkdir devices
cat >devices/talker.hpp <<'X'
#pragma once
#include <cstdint>
#include <finemote/contract.hpp>
#include <finemote/uart.hpp>
struct Talker {
  constexpr explicit Talker(finemote::Uart& uart) : uart_(&uart) {}
  void update() {}
  void handle() { uart_->write(words_, sizeof words_); }
  finemote::Stamp state;

 private:
  finemote::Uart* const uart_;
  std::uint8_t words_[16]{};
};
X
cat >devices/talker.json <<'X'
{ "schema": "finemote.device/1", "type": "talker", "summary": "says more than it declares", "class": "Talker",
  "header": "talker.hpp", "bus": { "types": ["uart"], "format": "8N1" }, "provides": [],
  "frames": [{ "stage": "handle", "write": 8 }], "wcet": { "update_ns": 1000, "handle_ns": 9000 } }
X
robot <<'X'
    <bus name="line" type="uart" port="usart6" baud="115200baud"/>
    <device name="talker" type="talker" bus="line" period="10ms"/>
X
finemote run robot.urdf --duration 50ms >/dev/null
