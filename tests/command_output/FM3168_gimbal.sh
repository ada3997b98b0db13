jointed_robot "$(
  joint yaw_joint continuous base_link turret_link "0 0 0" "0 0 1"
  joint pitch_joint revolute turret_link head_link "0 0 0.1" "0 -1 0" -0.3 0.6
  joint imu_joint fixed turret_link imu_link "0 0 0" "0 0 1"
)" <<X
$(pwm_expander)
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
X
finemote lint robot.urdf --allow FM3153 --allow FM3156
sed -i 's#highest">0.5rad#highest">0.3rad#; /name="imu_joint"/,/joint>/s#turret_link#head_link#' robot.urdf
finemote lint robot.urdf --allow FM3153 --allow FM3156
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
