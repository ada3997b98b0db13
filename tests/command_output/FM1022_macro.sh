xacro_robot <<'X'
  <xacro:macro name="rover.leg"/>
X
finemote xacro robot.urdf.xacro
