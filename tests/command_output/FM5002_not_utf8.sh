# names of files that are not UTF-8: of robots they are shown as well as they can be, a folder to keep is refused
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
cp robot.urdf $'robot\xff.urdf'
finemote generate $'robot\xff.urdf' -o out
finemote check $'robot\xff.urdf' -o out; echo "exit $?"
finemote run robot.urdf --duration 20ms --keep $'kept\xfe'
