xacro_robot <<'X'
  <xacro:macro name="thruster" params="name channel"/>
  <xacro:thruster name="left"/>
X
finemote xacro robot.urdf.xacro
