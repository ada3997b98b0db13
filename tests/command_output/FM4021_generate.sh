robot <<'X'
    <bus name="i2c" type="i2c" port="i2c2" clock="25kHz"/>
    <device name="depth" type="ms5837" bus="i2c" address="0x76" period="2ms"><wcet update="8us" handle="1us"/></device>
X
finemote -q generate robot.urdf -o out
echo "generate: $?"
finemote check robot.urdf -o out --deny FM3155 >/dev/null 2>&1
echo "check, denied: $?"
finemote analyze robot.urdf >/dev/null 2>said
echo "analyze: $? $(grep -c FM4021 said)"
finemote -q generate -W error robot.urdf -o refused 2>/dev/null
echo "generate -W error: $? $(ls refused 2>/dev/null | wc -l)"
