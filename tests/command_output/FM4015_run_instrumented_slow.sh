# a robot that meets its deadlines alone, and may not with the trace that was asked for: the verdict is that of the image
{ for number in 0 1 2 3 4 5 6 7 8 9; do
    printf '    <device name="load_%s" type="sim_load" period="1ms">' "$number"
    printf '<param name="update">10us</param><param name="handle">10us</param>'
    printf '<wcet update="48.6us" handle="48.6us" source="budget"/></device>\n'
  done; } | robot
finemote analyze robot.urdf >/dev/null; echo "analyze $?"
finemote analyze robot.urdf --trace >/dev/null 2>&1; echo "analyze --trace $?"
finemote run robot.urdf --duration 20ms >/dev/null; echo "run $?"
finemote run robot.urdf --duration 20ms --trace --format json >ran.json; echo "run --trace $?"
grep '"schedulable"' ran.json
