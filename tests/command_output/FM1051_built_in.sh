xacro_robot <<'X'
  <xacro:property name="pi" value="3"/>
X
finemote xacro robot.urdf.xacro
