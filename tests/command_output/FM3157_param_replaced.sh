jointed_robot "$(
  joint front_left_joint continuous base_link front_left_link "0.2 0.2 0" "0 1 0"
  joint front_right_joint continuous base_link front_right_link "0.2 -0.2 0" "0 1 0"
  joint rear_left_joint continuous base_link rear_left_link "-0.2 0.2 0" "0 1 0"
  joint rear_right_joint continuous base_link rear_right_link "-0.2 -0.2 0" "0 1 0"
)" <<'X'
    <bus name="dbus" type="uart" port="usart3" baud="100000baud"/>
    <bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
    <device name="chassis" type="mecanum_chassis" period="10ms">
      <param name="reach">0.4</param>
      <device name="remote" type="dr16" bus="dbus"/>
      <device name="front_left" type="dji_m3508" bus="can" id="1" joint="front_left_joint"/>
      <device name="front_right" type="dji_m3508" bus="can" id="2" joint="front_right_joint"/>
      <device name="rear_left" type="dji_m3508" bus="can" id="3" joint="rear_left_joint"/>
      <device name="rear_right" type="dji_m3508" bus="can" id="4" joint="rear_right_joint"/>
    </device>
X
finemote lint robot.urdf
