robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
cat >scenario.json <<'X'
{
  "schema": "finemote.scenario/1",
  "parts": [],
  "events": [
    { "at_ns": "soon", "part": "sticks" }
  ]
}
X
finemote run robot.urdf --scenario scenario.json
