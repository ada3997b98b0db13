robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote -q generate robot.urdf -o work/generated
sed -i 's/name="rover"/name="boat"/' robot.urdf
finemote run robot.urdf --board host --keep work
