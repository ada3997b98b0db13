robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o out
sed -i 's/10ms/20ms/' robot.urdf
finemote check robot.urdf -o out; echo "exit $?"
finemote check robot.urdf -o out --format gcc 2>/dev/null
finemote check robot.urdf -o out --format sarif 2>/dev/null | grep -E '"(ruleId|level|uri|text)"'
