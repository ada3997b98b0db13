robot <<'X'
    <bus name="sticks_uart" type="uart" port="usart3" baud="100000baud"/>
    <device name="sticks" type="dr16" bus="sticks_uart" period="10ms"/>
X
cat >scenario.json <<'Y'
{
  "schema": "finemote.scenario/1",
  "parts": [{ "type": "standing_body", "name": "hand" }],
  "events": [
    { "t_ns": 20000000, "part": "sticks", "do": "silent" },
    { "t_ns": 10000000, "part": "sticks", "do": "silent", "on": false }
  ],
  "expect": [
    { "from_ns": 9000000000, "part": "hand", "value": "yaw", "min": 0, "max": 1 }
  ]
}
Y
finemote=$(command -v finemote)
PATH=/nonexistent "$finemote" run robot.urdf --duration 50ms --scenario scenario.json
