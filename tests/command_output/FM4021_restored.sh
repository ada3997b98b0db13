robot <<'B'
    <bus name="i2c" type="i2c" port="i2c2" clock="25kHz"/>
    <device name="depth" type="ms5837" bus="i2c" address="0x76" period="2ms"><wcet update="8us" handle="1us"/></device>
B
finemote analyze robot.urdf | sed -n '1p;/^chains/,/^$/p;/^for information/,$p'
finemote analyze robot.urdf --format json 2>/dev/null | sed -n '/^  "schedulable"/,/^  "requirements"/p'
