xacro_robot <<'X'
  <xacro:include filename="legs/*.xacro"/>
X
finemote xacro robot.urdf.xacro
