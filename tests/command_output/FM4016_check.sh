# fresh files of a robot that fails a requirement
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/>
      <device name="sensor" type="sim_load"><wcet update="20us" handle="20us" source="budget"/></device>
    </device>
    <require latency="sensor -> load" max="1us"/>
Y
finemote -q generate robot.urdf -o out 2>/dev/null
finemote check robot.urdf -o out; echo "exit $?"
for format in gcc github; do finemote check robot.urdf -o out --format $format 2>/dev/null; done
finemote check robot.urdf -o out --format sarif 2>/dev/null | grep -E '"(ruleId|level|uri)"'
