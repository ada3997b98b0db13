xacro_robot <<'X'
  <xacro:property name="length" value="0.3"/>
  <link name="l${lenght / 2}"/>
X
finemote xacro robot.urdf.xacro
