xacro_robot <<'X'
  <link name="leg_${1 + 1"/>
X
finemote xacro robot.urdf.xacro
