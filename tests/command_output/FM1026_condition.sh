xacro_robot <<'X'
  <xacro:if value="yes"/>
X
finemote xacro robot.urdf.xacro
