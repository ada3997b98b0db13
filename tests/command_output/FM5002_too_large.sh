# a write that fails names the system's reason, and leaves everything as it was
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
trap '' XFSZ
(ulimit -f 1; finemote generate robot.urdf -o far/out)
echo "exit $?"; find . -type f | sort
finemote -q generate robot.urdf -o out; cp -r out before
sed -i 's/10ms/20ms/' robot.urdf
(ulimit -f 1; finemote generate robot.urdf -o out)
status=$?
diff -r before out && echo 'nothing changed'
exit $status
