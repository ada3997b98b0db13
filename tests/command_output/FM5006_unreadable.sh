# as somebody whom permissions hold
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
chmod 000 out/buses.cpp
as_somebody finemote check robot.urdf -o out; echo "exit $?"
chmod 644 out/buses.cpp
chmod 000 out
as_somebody finemote check robot.urdf -o out; echo "exit $?"
as_somebody finemote generate robot.urdf -o out; status=$?
chmod 555 out
as_somebody finemote generate robot.urdf -o out/inner/deep; echo "exit $?"
chmod 755 out
exit $status
