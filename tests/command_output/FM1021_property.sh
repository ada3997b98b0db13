xacro_robot <<'X'
  <xacro:property name="leg-length" value="0.3"/>
X
finemote xacro robot.urdf.xacro
