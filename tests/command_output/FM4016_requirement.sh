robot <<'X'
    <device name="base" type="sim_load" period="10ms">
      <wcet update="20us" handle="20us"/>
      <device name="imu" type="sim_load" period="5ms"><wcet update="20us" handle="20us"/></device>
    </device>
    <require latency="imu -> base" max="10us"/>
X
finemote analyze robot.urdf >/dev/null
