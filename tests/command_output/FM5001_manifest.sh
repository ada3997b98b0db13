# a broken manifest counts as empty: files that hold what this run writes are replaced, others are not
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
for broken in '{' '{"schema": "finemote.manifest/1", "tool": "t", "format": 1, "robot": "rover", "inputs": [], "outputs": [{"name": "../robot.urdf", "sha256": ""}]}'; do
  echo "$broken" >out/finemote.manifest.json
  finemote generate robot.urdf -o out
  echo "exit $?"
done
finemote check robot.urdf -o out
echo '{' >out/finemote.manifest.json
echo '// mine' >>out/buses.cpp
finemote -W error generate robot.urdf -o out
