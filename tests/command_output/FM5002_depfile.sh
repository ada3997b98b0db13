# a dependency file that cannot be written is found before anything is
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
finemote generate robot.urdf -o out --depfile nowhere/robot.d
ls -d out nowhere 2>/dev/null
finemote generate robot.urdf -o out --depfile out/robot.d -q && ls out/robot.d
finemote generate robot.urdf -o new/out --depfile new/robot.d -q && ls new
