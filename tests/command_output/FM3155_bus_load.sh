robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="10kHz"/>
    <device name="depth" type="ms5837" bus="i2c" address="0x76" period="10ms"><wcet update="8us" handle="1us"/></device>
X
finemote lint robot.urdf
