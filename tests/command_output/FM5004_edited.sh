# an edited file is not overwritten, and not removed with its tree; by CR alone it is not edited
robot <<'Y'
    <device name="arm" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
finemote -q generate robot.urdf -o out
sed -i 's/$/\r/' out/buses.cpp out/trees/arm.hpp out/trees/load.hpp
echo '// mine' >>out/trees/arm.cpp
echo '// mine' >>out/trees/load.cpp
sed -i '/"arm"/d' robot.urdf
cp -r out before
finemote generate robot.urdf -o out --dry-run 2>/dev/null; echo "exit $?"
finemote generate robot.urdf -o out --format gcc 2>/dev/null; echo "exit $?"
diff -r before out && echo 'nothing changed'
finemote generate robot.urdf -o out; echo "exit $?"
finemote generate robot.urdf -o out --force; echo "exit $?"
find out -type f | sort
finemote check robot.urdf -o out
