mkdir devices
echo >devices/cloud.hpp
cat >devices/cloud.json <<'X'
{
  "schema": "finemote.device/1", "type": "cloud", "summary": "more than a frame holds", "class": "own::Cloud", "header": "cloud.hpp",
  "provides": [{ "interface": "own::Cloud", "state_fields": [{ "name": "points", "type": "float", "count": 40 }] }]
}
X
robot <<'X'
    <bus name="tether" type="uart" port="usart6" baud="460800baud"/>
    <device name="pilot" type="host_link" bus="tether" period="10ms">
      <device name="cloud" type="cloud"/>
    </device>
X
finemote generate robot.urdf -o out
ls out
{
  echo '<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>'
  echo '<bus name="tether" type="uart" port="usart6" baud="460800baud"/><device name="pilot" type="host_link" bus="tether" period="10ms">'
  for n in $(seq 30); do echo "<device name=\"load_$n\" type=\"mover\"/>"; done
  echo '</device></finemote></robot>'
} >many.urdf
echo >devices/mover.hpp
cat >devices/mover.json <<'X'
{
  "schema": "finemote.device/1", "type": "mover", "summary": "takes a number", "class": "own::Mover", "header": "mover.hpp",
  "provides": [{ "interface": "own::Mover", "command": true, "command_fields": [{ "name": "effort", "type": "float" }] }]
}
X
finemote generate many.urdf -o out
