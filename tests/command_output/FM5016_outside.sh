# a robot is copied with all it reads, or not at all
mkdir -p robots/devices parts
cat >parts/wheel.xacro <<'X'
<robot/>
X
cat >robots/rover.urdf.xacro <<'X'
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="../parts/wheel.xacro"/>
  <link name="base_link"/>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
  </finemote>
</robot>
X
finemote init project --from robots/rover.urdf.xacro; echo "exit $?"
[ ! -e project ] && echo 'nothing was written'
mv parts robots/
sed -i 's|\.\./parts|parts|' robots/rover.urdf.xacro
finemote -q init project --from robots/rover.urdf.xacro | grep '^src'; echo "exit $?"
finemote -q check project/src/rover.urdf.xacro -o project/generated
sed -i 's/sim_load/sim_lode/' robots/rover.urdf.xacro
finemote init other --from robots/rover.urdf.xacro; echo "exit $?"
[ ! -e other ] && echo 'nothing was written'
