xacro_robot <<'X'
  <xacro:macro name="thruster" params="name channel"/>
  <xacro:thruster name="left" chanel="1"/>
X
finemote xacro robot.urdf.xacro
