robot <<'X'
    <device name="base" type="sim_load" period="20ms">
      <device name="imu" type="sim_load" period="1ms"/>
      <device name="motor" type="sim_load" period="2ms"><wcet update="200us" handle="100us"/></device>
    </device>
    <require latency="imu -> motor" of="decision" max="20ms"/>
    <require latency="motor -> elsewhere" max="20ms"/>
    <device name="elsewhere" type="sim_load" period="20ms"/>
X
finemote analyze robot.urdf >/dev/null
