# what is computed has to be XML: names, comments, characters
try() {
  cat >robot.xacro
  finemote xacro robot.xacro
}
try <<'X'
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:element xacro:name="a b=&quot;1&quot;"/>
</robot>
X
try <<'X'
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <q><xacro:attribute name="1 x&lt;" value="y"/></q>
</robot>
X
try <<'X'
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- xacro:eval-comments -->
  <!-- ${'-'*2} -->
</robot>
X
try <<'X'
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <b v="${'%c' % 1}"/>
</robot>
X
try <<'X'
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <b>${'%c' % 1}</b>
</robot>
X
