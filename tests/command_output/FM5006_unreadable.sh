# the superuser can read everything: as somebody else
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
chmod -R a+rwX . ..
as_somebody() { if [ "$(id -u)" = 0 ]; then setpriv --reuid 65534 --clear-groups "$(type -P finemote)" "$@"; else finemote "$@"; fi; }
chmod 000 out/buses.cpp
as_somebody check robot.urdf -o out; echo "exit $?"
chmod 644 out/buses.cpp
chmod 000 out
as_somebody check robot.urdf -o out; echo "exit $?"
as_somebody generate robot.urdf -o out; status=$?
chmod 755 out
as_somebody generate robot.urdf -o out/inner/deep; echo "exit $?"
exit $status
