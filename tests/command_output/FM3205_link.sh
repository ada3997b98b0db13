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
