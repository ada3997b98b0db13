cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="pan_link"/>
  <joint name="pan_joint" type="revolute">
    <parent link="base_link"/>
    <child link="pan_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-3" upper="1.5" effort="1" velocity="5"/>
  </joint>
  <link name="tilt_link"/>
  <joint name="tilt_joint" type="revolute">
    <parent link="base_link"/>
    <child link="tilt_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1.5708" upper="1.5708" effort="1" velocity="5"/>
  </joint>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c2"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <device name="pan" type="pwm_servo" period="20ms" bus="pwm" channel="0" joint="pan_joint"/>
    <device name="tilt" type="pwm_servo" period="20ms" bus="pwm" channel="1" joint="tilt_joint"/>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
