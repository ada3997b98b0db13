robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>
    <device name="base" type="sim_load" period="10ms">
      <device name="depth" type="ms5837" bus="i2c" address="0x76"/>
      <device name="motor" type="sim_load"/>
    </device>
    <require latency="depth -> motor" max="20ms"/>
X
finemote analyze robot.urdf >/dev/null
