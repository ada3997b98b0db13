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
descriptor hull
cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="f1_link"/>
  <joint name="f1_joint" type="continuous">
    <parent link="base_link"/>
    <child link="f1_link"/>
    <origin xyz="0.156 0.111 0.07"/>
    <axis xyz="0.7071 -0.7071 0"/>
  </joint>
  <link name="f2_link"/>
  <joint name="f2_joint" type="continuous">
    <parent link="base_link"/>
    <child link="f2_link"/>
    <origin xyz="0.156 -0.111 0.07"/>
    <axis xyz="0.7071 0.7071 0"/>
  </joint>
  <link name="f3_link"/>
  <joint name="f3_joint" type="continuous">
    <parent link="base_link"/>
    <child link="f3_link"/>
    <origin xyz="-0.156 0.111 0.07"/>
    <axis xyz="0.7071 0.7071 0"/>
  </joint>
  <link name="f4_link"/>
  <joint name="f4_joint" type="continuous">
    <parent link="base_link"/>
    <child link="f4_link"/>
    <origin xyz="-0.156 -0.111 0.07"/>
    <axis xyz="0.7071 -0.7071 0"/>
  </joint>
  <link name="v1_link"/>
  <joint name="v1_joint" type="continuous">
    <parent link="base_link"/>
    <child link="v1_link"/>
    <origin xyz="0 0.22 0.05"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="v2_link"/>
  <joint name="v2_joint" type="continuous">
    <parent link="base_link"/>
    <child link="v2_link"/>
    <origin xyz="0 -0.22 0.05"/>
    <axis xyz="0 0 1"/>
  </joint>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c2"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <device name="hull" type="hull" period="20ms">
      <device name="t0_hull" type="pwm_esc" bus="pwm" channel="0" joint="f1_joint"/>
      <device name="t1_hull" type="pwm_esc" bus="pwm" channel="1" joint="f2_joint"/>
      <device name="t2_hull" type="pwm_esc" bus="pwm" channel="2" joint="f3_joint"/>
      <device name="t3_hull" type="pwm_esc" bus="pwm" channel="3" joint="f4_joint"/>
      <device name="t4_hull" type="pwm_esc" bus="pwm" channel="4" joint="v1_joint"/>
      <device name="t5_hull" type="pwm_esc" bus="pwm" channel="5" joint="v2_joint"/>
    </device>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153
finemote lint robot.urdf --allow FM3153 --deny 3158 | head -1
finemote lint robot.urdf --allow FM3153 --allow FM3158
finemote tree robot.urdf --format json | grep base_link
