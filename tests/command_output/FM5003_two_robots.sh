robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote -q generate robot.urdf -o out
sed -i 's/name="rover"/name="boat"/' robot.urdf
finemote generate robot.urdf -o out
