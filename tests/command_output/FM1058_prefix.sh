xacro_robot <<'X'
  <xacro:macro name="xacro:leg"><link name="leg"/></xacro:macro>
  <xacro:leg/>
X
finemote xacro robot.urdf.xacro
