# files named on the command line are written whole or not at all
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
echo '<robot name="rover"/>' >plain.xacro
cp robot.urdf mended.urdf
finemote simulate robot.urdf -q --duration 20ms -o /dev/full >/dev/null; echo "exit $?"
finemote simulate robot.urdf -q --duration 20ms -o missing/trace.json >/dev/null; echo "exit $?"
finemote xacro plain.xacro -o /dev/full; echo "exit $?"
finemote -q generate robot.urdf -o out --depfile missing/robot.d; echo "exit $?"
finemote -q docs -o robot.urdf; echo "exit $?"
finemote -q run robot.urdf --keep robot.urdf/work; echo "exit $?"
TMPDIR=/missing finemote -q run robot.urdf; echo "exit $?"
echo mine >plain.urdf.tmp
ln -s real.urdf plain.urdf
finemote xacro plain.xacro -o plain.urdf
cat plain.urdf.tmp; readlink plain.urdf; cat real.urdf
ls
