# run --keep is no licence to overwrite a project
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
mkdir work
echo 'project(mine)' >work/CMakeLists.txt
finemote run robot.urdf --keep work
status=$?
cat work/CMakeLists.txt; ls work
exit $status
