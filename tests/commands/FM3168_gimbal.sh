cat >robot.urdf <<'X'
<robot name="r">
  <link name="base_link"/>
  <link name="turret_link"/>
  <joint name="yaw_joint" type="continuous">
    <parent link="base_link"/>
    <child link="turret_link"/>
    <origin xyz="0 0 0"/>
    <axis xyz="0 0 1"/>
  </joint>
  <link name="head_link"/>
  <joint name="pitch_joint" type="revolute">
    <parent link="turret_link"/>
    <child link="head_link"/>
    <origin xyz="0 0 0.1"/>
    <axis xyz="0 -1 0"/>
    <limit lower="-0.3" upper="0.6" effort="1" velocity="5"/>
  </joint>
  <link name="imu_link"/>
  <joint name="imu_joint" type="fixed">
    <parent link="turret_link"/>
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
    <device name="head" type="gimbal" period="10ms">
      <param name="pitch_lowest">-0.5rad</param>
      <param name="pitch_highest">0.5rad</param>
      <reads device="remote" role="remote"/>
      <reads device="imu" role="imu"/>
      <device name="yaw" type="dji_gm6020" role="yaw" bus="can" id="1" joint="yaw_joint"/>
      <device name="pitch" type="dji_gm6020" role="pitch" bus="can" id="2" joint="pitch_joint"/>
    </device>
  </finemote>
</robot>
X
finemote lint robot.urdf --allow FM3153 --allow FM3156
sed -i 's#highest">0.5rad#highest">0.3rad#; /name="imu_joint"/,/joint>/s#turret_link#head_link#' robot.urdf
finemote lint robot.urdf --allow FM3153 --allow FM3156
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
