xacro_robot <<'X'
  <xacro:property name="a" value="1" scop="global"/>
X
finemote xacro robot.urdf.xacro
