# lint --fix changes the order of devices and nothing else, takes comments along, and says what it leaves alone and why
head='<bus name="u" type="uart" port="usart1" baud="921600baud"/><bus name="esc" type="pwm" port="pwm1"/>'
esc='<device name="m" type="pwm_esc" bus="esc"><wcet update="4us" handle="6us"/></device>'
imu='<device name="imu" type="h30_imu" bus="u"><wcet update="200us" handle="1us"/></device>'
xacro() {  # what stands inside the group, and behind it
  cat >r.urdf.xacro <<X
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="x" default="true"/><link name="base_link"/>
<xacro:macro name="escs" params="n"><device name="\${n}" type="pwm_esc" bus="esc"><wcet update="4us" handle="6us"/></device></xacro:macro>
<xacro:property name="first" value="u"/>
<finemote version="1"><board name="robomaster_type_c"/>$head<device name="top" type="group" period="10ms"><wcet update="1us" handle="1us"/>
$1
</device>$2</finemote></robot>
X
}
fix() {  # a file that has to stay as it is
  cp "$1" before
  finemote lint "$@" --fix 2>&1 | grep -v '^ *[0-9]* |\|hint: \|note: handles\|note: actuator'
  cmp "$1" before && echo "as before"
}
echo '-- in a condition, or the other in one'
xacro "<xacro:if value=\"\$(arg x)\">$esc</xacro:if>
$imu"; fix r.urdf.xacro
xacro "$esc
<xacro:unless value=\"\$(arg x)\">$imu</xacro:unless>"; fix r.urdf.xacro x:=false
echo '-- over a property, a condition, a macro'
xacro "$esc
<xacro:property name=\"bb\" value=\"u\"/>
${imu/\"u\"/\"\$\{bb\}\"}"; fix r.urdf.xacro
xacro "$esc
<xacro:if value=\"\$(arg x)\"/>
$imu"; fix r.urdf.xacro
xacro "<xacro:escs n=\"m\"/>
$imu"; fix r.urdf.xacro
echo '-- from outside of the parent'
xacro "$esc" "${imu/type=/parent=\"top\" type=}"; fix r.urdf.xacro
echo '-- another order within a role'
mkdir devices
echo '{ "schema": "finemote.device/1", "type": "head", "summary": "for tests", "class": "Head", "header": "head.hpp", "provides": [],
  "roles": [{ "name": "eyes", "interface": "Imu", "min": 2, "max": 2 }, { "name": "motor", "interface": "Thruster", "min": 1, "max": 1 }] }' >devices/head.json
touch devices/head.hpp
eyes() {
  robot <<X
$head<bus name="v" type="uart" port="usart6" baud="921600baud"/><device name="top" type="$1" period="10ms"><wcet update="1us" handle="1us"/>
$esc
${imu/bus=/period=\"20ms\" bus=}
$(echo "$imu" | sed 's/"u"/"v"/; s/"imu"/"imu2"/')
</device>
X
}
eyes head; fix robot.urdf
eyes group; fix robot.urdf
echo '-- moved with its comments, over a comment and a device'
robot <<X
    $head
    <device name="top" type="group" period="10ms">
      <!-- the motor -->
      $esc <!-- after m -->

      <!-- the imu,
           upright -->
      <!-- and level -->
      $imu <!-- after imu -->
      <wcet update="1us" handle="1us"/>
    </device>
X
finemote lint robot.urdf --fix 2>&1; sed -n '/group/,/<wcet update="1us"/p' robot.urdf
echo '-- a part of them'
robot <<X
    $head
    <bus name="idle" type="can" port="can1" bitrate="1Mbit/s"/>
    <bus name="asked" type="can" port="can2" bitrate="1Mbit/s"/>
    <device name="top" type="group" period="10ms"><wcet update="1us" handle="1us"/>
      $esc
      $imu
    </device>
    <require utilization="asked" max="10%"/>
X
finemote lint robot.urdf --fix --format gcc; echo "exit $?"
finemote lint robot.urdf --fix; echo "exit $?"; grep -c idle robot.urdf
