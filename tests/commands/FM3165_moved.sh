mkdir devices
cat >devices/hull.hpp <<'X'
#pragma once
X
cat >devices/hull.json <<'X'
{ "schema": "finemote.device/1", "type": "hull", "summary": "pushes", "class": "Hull", "header": "hull.hpp",
  "roles": [{ "name": "thrusters", "interface": "Thruster", "min": 1 }, { "name": "imu", "interface": "Imu" }],
  "geometry": [{ "kind": "allocation", "role": "thrusters", "commands": ["fz"] }],
  "wcet": { "update_ns": 1000, "handle_ns": 1000 } }
X
cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="tilt_link"/>
  <joint name="tilt_joint" type="revolute">
    <parent link="base_link"/>
    <child link="tilt_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="5"/>
  </joint>
  <link name="follow_link"/>
  <joint name="follow_joint" type="revolute">
    <parent link="base_link"/>
    <child link="follow_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="5"/>
    <mimic joint="tilt_joint"/>
  </joint>
  <link name="a_link"/>
  <joint name="a_joint" type="continuous">
    <parent link="tilt_link"/>
    <child link="a_link"/>
    <origin xyz="0.2 0 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="b_link"/>
  <joint name="b_joint" type="continuous">
    <parent link="follow_link"/>
    <child link="b_link"/>
    <origin xyz="-0.2 0 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="c_link"/>
  <joint name="c_joint" type="revolute">
    <parent link="base_link"/>
    <child link="c_link"/>
    <origin xyz="0 0.2 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="5"/>
  </joint>
  <link name="d_link"/>
  <joint name="d_joint" type="continuous">
    <parent link="base_link"/>
    <child link="d_link"/>
    <origin xyz="0 0.2 0.0005"/>
    <axis xyz="0 0 -1"/>
  </joint>
  <link name="e_link"/>
  <joint name="e_joint" type="revolute">
    <parent link="base_link"/>
    <child link="e_link"/>
    <origin xyz="0 -0.2 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1e+16" upper="1e+16" effort="1" velocity="5"/>
  </joint>
  <link name="f_link"/>
  <joint name="f_joint" type="continuous">
    <parent link="base_link"/>
    <child link="f_link"/>
    <origin xyz="0 -0.2 0.1"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="imu_link"/>
  <joint name="imu_joint" type="fixed">
    <parent link="tilt_link"/>
    <child link="imu_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c2"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <bus name="can" type="can" port="can1"/>
    <bus name="dbus" type="uart" port="usart3" baud="100000baud"/>
    <bus name="imu_uart" type="uart" port="usart1" baud="921600baud"/>
    <device name="remote" type="dr16" bus="dbus" period="10ms"/>
    <device name="imu" type="h30_imu" bus="imu_uart" period="5ms" link="imu_link"/>
    <device name="tilt" type="pwm_servo" period="20ms" bus="pwm" channel="8" joint="tilt_joint">
      <param name="travel">2rad</param>
    </device>
    <device name="hull" type="hull" period="20ms" link="base_link">
      <reads device="imu" role="imu"/>
      <device name="a" type="pwm_esc" bus="pwm" channel="0" joint="a_joint"/>
      <device name="b" type="pwm_esc" bus="pwm" channel="1" joint="b_joint"/>
      <device name="c" type="pwm_esc" bus="pwm" channel="2" joint="c_joint"/>
      <device name="d" type="pwm_esc" bus="pwm" channel="3" joint="d_joint"/>
      <device name="e" type="pwm_esc" bus="pwm" channel="4" joint="e_joint"/>
      <device name="f" type="pwm_esc" bus="pwm" channel="5" joint="f_joint"/>
    </device>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153 --allow FM3152
finemote -q lint robot.urdf --allow FM3153 --allow FM3152 --allow FM3163 --allow FM3164 --allow FM3165 --allow FM3167
