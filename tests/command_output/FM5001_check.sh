robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
echo '{"schema": 1}' >out/finemote.manifest.json
finemote check robot.urdf -o out; echo "exit $?"
finemote check robot.urdf -o out --format json 2>/dev/null | grep -E '"(fresh|code|state)"'
rm out/finemote.manifest.json
finemote check robot.urdf -o out
