# other arguments and another board are why files differ
xacro_robot <<'Y'
  <link name="base_link"/>
  <xacro:arg name="p" default="10ms"/>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <device name="load" type="sim_load" period="$(arg p)"><wcet update="20us" handle="20us" source="budget"/></device>
  </finemote>
Y
finemote -q generate robot.urdf.xacro p:=20ms -o out
finemote check robot.urdf.xacro -o out; echo "exit $?"
finemote check robot.urdf.xacro p:=50ms --board qemu_f405 -o out; echo "exit $?"
finemote check robot.urdf.xacro p:=20ms -o out --format gcc; echo "exit $?"
finemote check robot.urdf.xacro -o out --format gcc 2>/dev/null
