# Arguments that nobody declares: a warning with the nearest name; declared, read and evaluated ones are known.
xacro_robot <<'X'
  <xacro:arg name="pitch_motor" default="3"/>
  <link name="$(arg free)_$(eval other + 1)"/>
X
finemote xacro robot.urdf.xacro pitch_moter:=4 free:=a other:=1
finemote xacro -q robot.urdf.xacro pitch_moter:=4 free:=a other:=1 >/dev/null && echo "quiet says nothing"
xacro_robot <<'X'
  <link name="base_link"/>
X
finemote xacro robot.urdf.xacro speed:=4 >/dev/null
sed -i 's#</robot>#<finemote version="1"><board name="robomaster_type_c"/><device name="l" type="sim_load" period="10ms"/></finemote></robot>#' robot.urdf.xacro
finemote tree robot.urdf.xacro speed:=4 >/dev/null
