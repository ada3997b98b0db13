xacro_robot <<'X'
  <xacro:include filename="leg.xacro"/>
X
finemote xacro robot.urdf.xacro
