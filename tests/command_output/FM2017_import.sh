# nothing to import, something that is imported already, and what a robot with all kinds of parts lacks
xacro_robot </dev/null
finemote import robot.urdf.xacro
cat >robot.urdf <<'X'
<robot name="r">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
  <joint name="1 wheel--left" type="continuous"><parent link="base"/><child link="a"/></joint>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="b"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <joint name="mast" type="fixed"><parent link="base"/><child link="c"/></joint>
  <joint name="finger" type="revolute"><parent link="base"/><child link="d"/><mimic joint="lift"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <link name="e"/><joint name="tilt" type="revolute"><parent link="base"/><child link="e"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <ros2_control name="base" type="system" rw_rate="300">
    <hardware><plugin> a/b--c </plugin></hardware>
    <joint name="1 wheel--left"><command_interface name="effort"/></joint>
    <joint name="lift"><command_interface name="position"/></joint>
    <joint name="tilt"><command_interface name="position"/></joint>
    <joint name="finger"><command_interface name="position"/></joint>
    <joint name="mast"><command_interface name="position"/></joint>
    <joint name="ghost"><command_interface name="position"/></joint>
    <sensor name="Base"><state_interface name="orientation.x"/></sensor>
    <sensor name="second"><state_interface name="angular_velocity.x"/></sensor>
    <sensor name="force"><state_interface name="force.x"/></sensor>
  </ros2_control>
  <ros2_control name="lamps" type="system"><gpio name="lamp"/></ros2_control>
  <ros2_control name="twin" type="actuator">
    <joint name="lift"><command_interface name="stiffness"/></joint>
    <joint name="1 wheel--left"><state_interface name="position"/></joint>
  </ros2_control>
</robot>
X
finemote import robot.urdf -o whole.urdf; finemote import robot.urdf -q
finemote -q generate whole.urdf -o out 2>&1 | grep error; finemote import whole.urdf
finemote import robot.urdf -o robot.urdf
