takes() { printf '    <joint name="%s">' "$1"; shift; printf '<command_interface name="%s"/>' "$@"; printf '</joint>\n'; }
jointed_robot "$(for name in flap wheel lone still arm_1 prop free other; do
    joint $name continuous base_link ${name}_link "0 0 0" "0 0 1"
  done
  joint arm_2 continuous arm_1_link arm_2_link "0 0 0.1" "0 1 0"
  echo '  <ros2_control name="r" type="system">'
  takes flap velocity
  takes wheel position velocity
  takes lone effort
  echo '    <joint name="still"><state_interface name="position"/></joint>'
  takes arm_1 position
  takes arm_2 velocity
  takes prop position
  takes free acceleration
  takes other current
  echo '  </ros2_control>
  <ros2_control name="sim" type="system">'
  takes wheel acceleration
  echo '  </ros2_control>')" <<'X'
    <bus name="pwm" type="pwm" port="pwm1"/>
    <bus name="esc" type="pwm" port="pwm2"/>
    <bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
    <bus name="dbus" type="uart" port="usart3" baud="100000baud"/>
    <device name="base" type="group" period="10ms">
      <device name="flap" type="pwm_servo" bus="pwm" channel="0" joint="flap"/>
      <device name="wheel" type="dji_m3508" bus="can" id="1" joint="wheel"/>
      <device name="still" type="dji_m3508" bus="can" id="2" joint="still"/>
      <device name="prop" type="pwm_esc" bus="esc" channel="0" joint="prop"/>
      <device name="free" type="dji_m3508" bus="can" id="3" joint="free"/>
      <device name="other" type="dji_m3508" bus="can" id="4" joint="other"/>
    </device>
    <device name="lone" type="dji_m3508" bus="can" id="5" joint="lone" period="10ms"/>
    <device name="arm" type="serial_arm" period="10ms">
      <device name="remote" type="dr16" bus="dbus"/>
      <device name="arm_1" type="dji_m3508" bus="can" id="6" joint="arm_1"/>
      <device name="arm_2" type="dji_m3508" bus="can" id="7" joint="arm_2"/>
    </device>
X
finemote lint robot.urdf --allow FM3151 --allow FM3153 --allow FM3155 --allow FM3165 --allow FM3166
