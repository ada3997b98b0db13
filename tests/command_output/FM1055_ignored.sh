echo '<robot/>' >part.xacro
xacro_robot <<'X'
  <xacro:include filename="part.xacro"><link name="never"/></xacro:include>
X
finemote xacro robot.urdf.xacro
