robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>
    <device name="depth" type="ms5837" bus="i2c" address="0x76" period="2ms">
      <param name="oversampling">8192</param>
      <wcet update="8us" handle="1us"/>
    </device>
X
finemote lint robot.urdf
