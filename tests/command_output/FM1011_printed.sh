# a limit that strikes while a value becomes text is located at that text
xacro_robot <<'X'
  <xacro:property name="big" value="${[1, 2, 3, 4, 5, 6, 7, 8, 9, 10] * 300000}"/>
  <b/>
  <c v="${big}${big}"/>
X
finemote xacro robot.urdf.xacro
