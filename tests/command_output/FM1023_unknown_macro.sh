xacro_robot <<'X'
  <xacro:macro name="thruster" params="name"/>
  <xacro:truster name="left"/>
X
finemote xacro robot.urdf.xacro
