robot <<'X'
    <bus name="serial" type="uart" port="usart1" baud="115200baud"/>
    <device name="base" type="group" period="10ms">
      <device name="imu" type="h30_imu" bus="serial"><wcet update="20us" handle="1us"/></device>
    </device>
X
finemote lint robot.urdf
