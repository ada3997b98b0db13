xacro_robot <<'X'
  <xacro:property name="legs" value="5"/>
  ${xacro.fatal('a leg is missing: ', legs)}
X
finemote xacro robot.urdf.xacro
