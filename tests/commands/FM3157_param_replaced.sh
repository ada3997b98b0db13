cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="front_left_link"/>
  <joint name="front_left_joint" type="continuous">
    <parent link="base_link"/>
    <child link="front_left_link"/>
    <origin xyz="0.2 0.2 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="front_right_link"/>
  <joint name="front_right_joint" type="continuous">
    <parent link="base_link"/>
    <child link="front_right_link"/>
    <origin xyz="0.2 -0.2 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="rear_left_link"/>
  <joint name="rear_left_joint" type="continuous">
    <parent link="base_link"/>
    <child link="rear_left_link"/>
    <origin xyz="-0.2 0.2 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="rear_right_link"/>
  <joint name="rear_right_joint" type="continuous">
    <parent link="base_link"/>
    <child link="rear_right_link"/>
    <origin xyz="-0.2 -0.2 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <finemote version="1">
    <board name="robomaster_type_c"/>
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
  </finemote>
</robot>
X
finemote lint robot.urdf
