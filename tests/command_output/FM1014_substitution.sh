xacro_robot <<'X'
  <link name="$(argh name)"/>
X
finemote xacro robot.urdf.xacro
