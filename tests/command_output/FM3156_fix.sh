# a bus that other arguments of the file could use, or that a requirement names, stays
cat >r.urdf.xacro <<'X'
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="gps" default="false"/><link name="base_link"/>
<finemote version="1"><board name="robomaster_type_c"/>
<bus name="u" type="uart" port="usart1" baud="921600baud"/>
<bus name="u2" type="uart" port="usart6" baud="921600baud"/>
<device name="imu" type="h30_imu" bus="u" period="10ms"><wcet update="200us" handle="1us"/></device>
<xacro:if value="$(arg gps)"><device name="imu2" type="h30_imu" bus="u2" period="10ms"><wcet update="200us" handle="1us"/></device></xacro:if>
</finemote></robot>
X
cp r.urdf.xacro before
finemote lint r.urdf.xacro --fix; echo "exit $?"; cmp r.urdf.xacro before
finemote -q lint r.urdf.xacro gps:=true; echo "exit $?"
robot <<'X'
    <bus name="idle" type="can" port="can1" bitrate="1Mbit/s"/>
    <device name="load" type="sim_load" period="10ms"><wcet update="2us" handle="20us" source="budget"/></device>
    <require utilization="idle" max="10%"/>
X
finemote lint robot.urdf --fix -W error; echo "exit $?"; grep -c idle robot.urdf
sed -i '/require/d' robot.urdf
finemote lint robot.urdf --fix -W error; echo "exit $?"; grep -c idle robot.urdf
