mkdir devices
cat >devices/hull.hpp <<'X'
#pragma once
X
descriptor() { cat >devices/$1.json <<X
{ "schema": "finemote.device/1", "type": "$1", "summary": "pushes", "class": "Hull", "header": "hull.hpp",
  "roles": [{ "name": "thrusters", "interface": "Thruster", "min": 1 }],
  "geometry": [{ "kind": "allocation", "role": "thrusters"$2 }], "wcet": { "update_ns": 1000, "handle_ns": 1000 } }
X
}
descriptor hull ', "commands": ["fz", "mx"]'
cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="a_link"/>
  <joint name="a_joint" type="continuous">
    <parent link="base_link"/>
    <child link="a_link"/>
    <origin xyz="0.5 0.001 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="b_link"/>
  <joint name="b_joint" type="continuous">
    <parent link="base_link"/>
    <child link="b_link"/>
    <origin xyz="-0.5 0.001 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="c_link"/>
  <joint name="c_joint" type="continuous">
    <parent link="base_link"/>
    <child link="c_link"/>
    <origin xyz="0 -0.001 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c2"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <device name="hull" type="hull" period="20ms">
      <device name="t0_hull" type="pwm_esc" bus="pwm" channel="0" joint="a_joint"/>
      <device name="t1_hull" type="pwm_esc" bus="pwm" channel="1" joint="b_joint"/>
      <device name="t2_hull" type="pwm_esc" bus="pwm" channel="2" joint="c_joint"/>
    </device>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153
