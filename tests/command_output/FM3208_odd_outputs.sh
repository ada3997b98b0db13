robot <<'X'
    <bus name="line" type="rs485" port="usart1" baud="115200baud">
      <param name="direction">PI0</param>
    </bus>
    <bus name="warmth" type="pwm" port="imu_heater"/>
    <bus name="red" type="pwm" port="led_red"/>
    <device name="panel" type="group" period="10ms">
      <wcet update="5us" handle="5us" source="budget"/>
      <device name="loose" type="key"><use role="line" pin="PI1"/><wcet update="5us" handle="5us" source="budget"/></device>
      <device name="wired" type="key"><use role="line" pin="PB13"/><wcet update="5us" handle="5us" source="budget"/></device>
      <device name="status" type="led" bus="red"><wcet update="5us" handle="5us" source="budget"/></device>
      <device name="warm" type="led" bus="warmth"><wcet update="5us" handle="5us" source="budget"/></device>
    </device>
X
finemote lint --allow FM3156 robot.urdf
finemote lint --allow FM3156 --deny FM3208 robot.urdf >denied.txt 2>&1; echo "denied: $?"
finemote lint --allow FM3156 --allow FM3208 robot.urdf
