robot <<'X'
    <bus name="shaft" type="pwm" port="pwm1"/>
    <bus name="imu_uart" type="uart" port="usart1" baud="921600baud"/>
    <device name="base" type="group" period="10ms">
      <device name="motor" type="pwm_esc" bus="shaft" channel="0"><wcet update="1us" handle="2us"/></device>
      <device name="imu" type="h30_imu" bus="imu_uart"><wcet update="20us" handle="1us"/></device>
    </device>
X
finemote lint robot.urdf
