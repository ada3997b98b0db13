robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
echo mine >out
finemote generate robot.urdf -o out
status=$?
cat out
exit $status
