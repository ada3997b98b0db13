cat >robot.urdf <<'B'
<robot name="r">
  <link name="base"/>
  <finemote version="1">
    <board name="robomaster_type_c" tick="50us"/>
    <bus name="i2c" type="i2c" port="i2c2" clock="10kHz"/>
    <device name="one" type="sim_load" period="150us"><wcet update="2us" handle="1us"/></device>
    <device name="two" type="sim_load" period="200us"><wcet update="2us" handle="1us"/></device>
    <device name="depth" type="ms5837" bus="i2c" address="0x76" period="42ms"><wcet update="16us" handle="1us"/></device>
  </finemote>
</robot>
B
finemote analyze robot.urdf 2>&1 >/dev/null
echo "analyze: $?"
finemote analyze robot.urdf --format json 2>/dev/null | sed -n '/^  "target"/,/^    "buckets"/p'
finemote analyze robot.urdf 2>/dev/null | grep "has no bound"
sed -i 's/150us/200us/' robot.urdf
finemote -q analyze robot.urdf >/dev/null
echo "of one period: $?"
sed -i 's/"200us"/"150ms"/; s/"42ms"/"150ms"/' robot.urdf
finemote analyze robot.urdf 2>&1 >/dev/null | grep "as close\|in between\|hint: .*tick"
