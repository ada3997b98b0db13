xacro_robot <<'X'
  <xacro:macro name="leg"><xacro:leg/></xacro:macro>
  <xacro:leg/>
X
finemote xacro robot.urdf.xacro
