robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote -q generate robot.urdf -o out
sed -i 's/name="rover"/name="boat"/' robot.urdf
finemote check robot.urdf -o out
echo "// mine" >>out/schedule.cpp
finemote generate robot.urdf -o out --force --dry-run
finemote generate robot.urdf -o out --force
finemote check robot.urdf -o out && ls out
