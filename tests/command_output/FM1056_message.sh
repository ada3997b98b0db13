xacro_robot <<'X'
  ${xacro.warning('this leg is untested')}
X
finemote xacro robot.urdf.xacro
