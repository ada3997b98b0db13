robot <<'X'
    <bus name="imu_uart" type="uart" port="usart1" baud="921600baud"/>
    <bus name="esc" type="pwm" port="pwm1"/>
    <device name="rov" type="group" period="10ms">
      <device name="imu" type="h30_imu" bus="imu_uart">
        <wcet update="100us" handle="10us" source="budget"/>
      </device>
      <device name="thruster" type="pwm_esc" bus="esc">
        <wcet update="5us" handle="10us" source="budget"/>
        <param name="max_age">5ms</param>
      </device>
    </device>
X
finemote lint robot.urdf
finemote lint --deny FM3161 robot.urdf >denied.txt; echo "denied: $?"
finemote lint --allow FM3161 robot.urdf
sed -i 's/5ms/20ms/' robot.urdf
finemote lint robot.urdf
