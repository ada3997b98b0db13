xacro_robot <<'X'
  <link name="$(arg side)"/>
X
finemote xacro robot.urdf.xacro
