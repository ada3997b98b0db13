# two names of one robot are no difference; the file named is no difference in text either
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
cp robot.urdf copy.urdf
finemote diff robot.urdf copy.urdf; echo "exit $?"
sed -i 's/10ms/20ms/' copy.urdf
finemote diff robot.urdf copy.urdf | grep -c 'Source:'
finemote diff robot.urdf
