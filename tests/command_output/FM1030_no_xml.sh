# what is computed has to be XML: names, comments, characters
try() {
  xacro_robot
  finemote xacro robot.urdf.xacro
}
try <<'X'
  <xacro:element xacro:name="a b=&quot;1&quot;"/>
X
try <<'X'
  <q><xacro:attribute name="1 x&lt;" value="y"/></q>
X
try <<'X'
  <!-- xacro:eval-comments -->
  <!-- ${'-'*2} -->
X
try <<'X'
  <b v="${'%c' % 1}"/>
X
try <<'X'
  <b>${'%c' % 1}</b>
X
try <<'X'
  <xacro:element xacro:name="größe"><xacro:attribute name="a-1.b:c" value="&lt;"/></xacro:element>
X
