xacro_robot <<'X'
  <xacro:macro name="leg" params="*origin"><xacro:insert_block name="orign"/></xacro:macro>
  <xacro:leg><origin/></xacro:leg>
X
finemote xacro robot.urdf.xacro
