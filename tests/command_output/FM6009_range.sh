robot <<'X'
    <bus name="sticks_uart" type="uart" port="usart3" baud="100000baud"/>
    <device name="sticks" type="dr16" bus="sticks_uart" period="10ms"/>
X
cat >scenario.json <<'Y'
{
  "schema": "finemote.scenario/1",
  "events": [
    { "t_ns": 100000000, "part": "sticks", "do": "move", "left_y": 5 },
    { "t_ns": -1, "part": "sticks", "do": "move", "left_switch": "upp" },
    { "t_ns": 1e999, "port": "usart3", "do": "noise", "bytes": 0.5 }
  ]
}
Y
finemote run robot.urdf --scenario scenario.json
