xacro_robot <<'X'
  <xacro:include file="leg.xacro"/>
X
finemote xacro robot.urdf.xacro
