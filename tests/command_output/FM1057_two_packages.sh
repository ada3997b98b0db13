for place in one two; do
  mkdir -p $place/rover_description
  echo '<package><name>rover_description</name></package>' >$place/rover_description/package.xml
  echo '<robot/>' >$place/rover_description/leg.xacro
done
xacro_robot <<'X'
  <xacro:include filename="$(find rover_description)/leg.xacro"/>
X
ROS_PACKAGE_PATH=one:two finemote xacro robot.urdf.xacro
