xacro_robot <<'X'
  <a><xacro:if value="1"><xacro:attribute name="c" value="1"/></xacro:if></a>
X
finemote xacro robot.urdf.xacro >/dev/null
