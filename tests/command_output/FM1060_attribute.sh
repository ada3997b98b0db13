# Where ROS xacro loses an attribute: conditions, macros, included files, blocks; not inside an element of them.
echo '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:attribute name="i" value="1"/></robot>' >part.xacro
xacro_robot <<'X'
  <xacro:macro name="m"><xacro:attribute name="m" value="1"/></xacro:macro>
  <xacro:property name="block"><xacro:attribute name="b" value="1"/></xacro:property>
  <a><xacro:if value="1"><xacro:attribute name="c" value="1"/></xacro:if></a>
  <a><xacro:unless value="1"><xacro:attribute name="c" value="1"/></xacro:unless></a>
  <a><xacro:m/></a>
  <a><xacro:include filename="part.xacro"/></a>
  <a><xacro:insert_block name="block"/></a>
  <a><xacro:if value="1"><b><xacro:attribute name="fine" value="1"/></b></xacro:if></a>
X
finemote xacro robot.urdf.xacro
