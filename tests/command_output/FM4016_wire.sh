robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="40kHz"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <device name="base" type="sim_load" period="10ms">
      <device name="imu" type="sim_load"/>
      <device name="left" type="pwm_esc" bus="pwm" channel="0"/>
      <device name="right" type="pwm_esc" bus="pwm" channel="15"/>
    </device>
    <require latency="imu -> base.children" max="5ms"/>
X
finemote analyze robot.urdf >/dev/null
