xacro_robot <<'X'
  <xacro:arg name="pitch_motor" default="3"/>
X
finemote xacro robot.urdf.xacro pitch_moter:=4 >/dev/null
