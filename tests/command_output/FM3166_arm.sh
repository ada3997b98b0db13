jointed_robot "$(
  joint shoulder revolute base_link upper "0 0 0" "0 1 0" -1 1.5
  joint swing revolute upper middle "0 0 0.3" "0 1 0" -1 1
  joint elbow continuous middle fore "0 0 0.3" "0 1 0"
  joint imu_joint fixed base_link imu_link "0 0 0" "0 0 1"
)" <<X
$(pwm_expander)
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
X
finemote lint robot.urdf --allow FM3153
sed -i 's#<device name="arm".*#&<param name="weight">0</param>#' robot.urdf
finemote -q lint robot.urdf --allow FM3153 --allow FM3165
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
