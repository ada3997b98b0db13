# where a file system takes upper and lower case for one, a root that is renamed by its case keeps its files: simulated by a
# second name for each
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
sed -i 's/name="load"/name="Load"/' robot.urdf
for file in out/trees/load.*; do ln "$file" "out/trees/L${file#out/trees/l}"; done
finemote check robot.urdf -o out; echo "exit $?"
finemote generate robot.urdf -o out -v; echo "exit $?"
ls out/trees
grep -c 'trees/Load' out/finemote.manifest.json
