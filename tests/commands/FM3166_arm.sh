cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="upper"/>
  <joint name="shoulder" type="revolute">
    <parent link="base_link"/>
    <child link="upper"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1.5" effort="1" velocity="5"/>
  </joint>
  <link name="middle"/>
  <joint name="swing" type="revolute">
    <parent link="upper"/>
    <child link="middle"/>
    <origin xyz="0 0 0.3"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="5"/>
  </joint>
  <link name="fore"/>
  <joint name="elbow" type="continuous">
    <parent link="middle"/>
    <child link="fore"/>
    <origin xyz="0 0 0.3"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="imu_link"/>
  <joint name="imu_joint" type="fixed">
    <parent link="base_link"/>
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
    <device name="swing" type="pwm_servo" period="20ms" bus="pwm" channel="8" joint="swing">
      <param name="travel">2rad</param>
    </device>
    <device name="arm" type="serial_arm" period="10ms">
      <reads device="remote" role="remote"/>
      <device name="shoulder" type="dji_m3508" bus="can" id="1" joint="shoulder"/>
      <device name="elbow" type="dji_m3508" bus="can" id="2" joint="elbow"/>
    </device>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153
sed -i 's#<device name="arm".*#&<param name="weight">0</param>#' robot.urdf
finemote -q lint robot.urdf --allow FM3153 --allow FM3165
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
