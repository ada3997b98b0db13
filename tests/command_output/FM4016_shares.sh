robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="100kHz"/>
    <device name="base" type="sim_load" period="10ms">
      <wcet update="2ms" handle="1ms"/>
      <device name="depth" type="ms5837" bus="i2c" address="0x76"/>
      <device name="imu" type="sim_load" period="5ms"/>
    </device>
    <require utilization="cpu" max="20%"/>
    <require utilization="i2c" max="2%"/>
    <require jitter="base" max="100us"/>
X
finemote analyze robot.urdf >/dev/null
