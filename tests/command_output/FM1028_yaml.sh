printf 'legs: [1, 2\nname: x\n' >legs.yaml
xacro_robot <<'X'
  <xacro:property name="legs" value="${xacro.load_yaml('legs.yaml')}"/>
  <link name="${legs}"/>
X
finemote xacro robot.urdf.xacro
