# one mistake in a macro that is expanded five times, in every format
xacro_robot <<'X'
  <xacro:macro name="wheel" params="name id">
    <finemote>
      <device name="${name}" type="dji_m350" bus="can" id="${id}"/>
    </finemote>
  </xacro:macro>
  <xacro:macro name="axle" params="name id">
    <xacro:wheel name="${name}_left" id="${id}"/>
    <xacro:wheel name="${name}_right" id="${id + 1}"/>
  </xacro:macro>
  <link name="base_link"/>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="can" type="can" port="can1"/>
  </finemote>
  <xacro:wheel name="spare" id="7"/>
  <xacro:axle name="front" id="1"/>
  <xacro:axle name="rear" id="3"/>
X
for format in text json gcc github sarif; do
  finemote --format $format tree robot.urdf.xacro
done 2>/dev/null
finemote tree robot.urdf.xacro
