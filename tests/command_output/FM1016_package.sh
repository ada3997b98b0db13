xacro_robot <<'X'
  <xacro:include filename="$(find rover_description)/urdf/leg.xacro"/>
X
finemote xacro robot.urdf.xacro
