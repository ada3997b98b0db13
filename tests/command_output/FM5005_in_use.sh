robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
mkdir out
flock --no-fork out sh -c 'touch locked; exec sleep 60' & holder=$!
while kill -0 $holder && [ ! -e locked ]; do sleep 0.1; done
finemote generate robot.urdf -o out
status=$?
kill $holder
wait 2>/dev/null
ls out
exit $status
