# The order of the children of a link is that of its frames: a program on the computer would read the wrong values.
robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>
    <bus name="pc" type="uart" port="usart1" baud="921600baud"/>
    <device name="link" type="host_link" bus="pc" period="20ms">
      <device name="esc" type="pwm_esc" bus="pwm" channel="0"/>
      <device name="baro" type="ms5837" bus="i2c"/>
    </device>
X
cp robot.urdf before.urdf
finemote lint robot.urdf --fix --allow FM3153
cmp robot.urdf before.urdf && echo unchanged
