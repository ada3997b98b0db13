echo '<robot xmlns:sim="http://one"/>' >part.xacro
echo '<robot xmlns:sim="http://two"/>' >other.xacro
xacro_robot <<'X'
  <xacro:include filename="part.xacro"/>
  <xacro:include filename="other.xacro"/>
X
finemote xacro robot.urdf.xacro
