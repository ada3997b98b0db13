# The secrets of a CI stand in its environment: no file reads them in the sandbox.
export TOKEN=5f2a ROS_PACKAGE_PATH=$PWD/ws
mkdir -p ws/arm
echo '<package><name>arm</name></package>' >ws/arm/package.xml
echo '<robot/>' >ws/arm/arm.xacro
xacro_robot <<'X'
  <link name="$(optenv TOKEN none)"/>
X
finemote xacro --sandbox robot.urdf.xacro
xacro_robot <<'X'
  <link name="$(env TOKEN)"/>
X
finemote xacro --sandbox robot.urdf.xacro
finemote xacro robot.urdf.xacro | grep -c 5f2a
xacro_robot <<'X'
  <link name="${xacro.message('::add-mask::x\n::error::x')}"/>
X
finemote xacro --sandbox robot.urdf.xacro >/dev/null
xacro_robot <<'X'
  <xacro:include filename="$(find arm)/arm.xacro"/>
X
finemote xacro --sandbox robot.urdf.xacro && echo unexpected
finemote xacro --sandbox --package arm=ws/arm robot.urdf.xacro >/dev/null && echo "a package that is named is read"
