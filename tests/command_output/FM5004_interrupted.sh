# what a killed run left: files in place whose manifest was not yet, and files under temporary names
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
sed -i 's/10ms/20ms/' robot.urdf
finemote -q generate robot.urdf -o next
cp next/schedule.cpp out; cp next/trees/load.cpp out/trees
echo half >out/buses.cpp.finemote-tmp-7
sed -i 's/20ms/30ms/' robot.urdf
finemote generate robot.urdf -o out; echo "exit $?"
cp next/finemote.manifest.json out/finemote.manifest.json.finemote-tmp-7
finemote generate robot.urdf -o out; echo "exit $?"
find out -type f | sort
finemote check robot.urdf -o out
