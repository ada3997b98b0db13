robot <<'X'
    <bus name="sticks" type="uart" port="usart3" baud="100000baud"/>
    <bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
    <device name="remote" type="dr16" bus="sticks" period="10ms"/>
    <device name="chassis" type="group" period="10ms">
      <reads device="remote" role="children"/>
      <device name="left" type="group"><device name="left_motor" type="dji_m3508" bus="can" id="1"/></device>
      <device name="right" type="group"><device name="right_motor" type="dji_m3508" bus="can" id="2"/></device>
    </device>
X
finemote analyze robot.urdf --chain 'left_motor->chassis.children' --format json 2>stderr.txt |
  grep -E '"(from|to)"' | tr -d ' \n'
echo
finemote analyze robot.urdf --chain 'remote->chassis.wheels'
