robot <<'X'
    <device name="slow" type="sim_load" period="10ms"><wcet update="6ms" handle="5ms"/></device>
X
finemote generate robot.urdf -o out
status=$?
ls
exit $status
