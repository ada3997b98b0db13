echo 'a: 1' >legs.yaml
xacro_robot <<'X'
  <link name="${load_yaml('legs.yaml')['a']}"/>
X
finemote xacro robot.urdf.xacro
