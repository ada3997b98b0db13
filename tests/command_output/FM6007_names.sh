robot <<'X'
    <bus name="sticks_uart" type="uart" port="usart3" baud="100000baud"/>
    <device name="sticks" type="dr16" bus="sticks_uart" period="10ms"/>
X
cat >scenario.json <<'Y'
{
  "schema": "finemote.scenario/1",
  "events": [
    { "t_ns": 100000000, "part": "sticks", "do": "move", "lefty": 0.5 },
    { "t_ns": 200000000, "part": "stick", "do": "silent" },
    { "t_ns": 300000000, "part": "sticks", "do": "silence" },
    { "t_ns": 400000000, "port": "can1", "do": "silent" }
  ],
  "expects": [],
  "expect": [
    { "from_ns": 50000000, "part": "sticks", "value": "left_y", "min": 0, "max": 1 }
  ]
}
Y
status=0
finemote run robot.urdf --scenario scenario.json --keep work || status=$?
test ! -e work && exit $status  # nothing was generated or compiled
