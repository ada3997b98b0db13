robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
rm out/buses.cpp
finemote check robot.urdf -o out; echo "exit $?"
for format in gcc github; do finemote check robot.urdf -o out --format $format 2>/dev/null; done
finemote check robot.urdf -o out --format json 2>/dev/null | sed -n '/"diagnostics"/,$p'
