# files that finemote did not write are refused, with and without --dry-run, and kept with --force
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
mkdir -p out/trees
for file in buses.cpp schedule.cpp trees/load.cpp; do echo "mine $file" >out/$file; done
cp -r out before
finemote generate robot.urdf -o out --dry-run; echo "exit $?"
finemote generate robot.urdf -o out; echo "exit $?"
diff -r before out && echo 'nothing changed'
finemote generate robot.urdf -o out --force --dry-run; echo "exit $?"
diff -r before out && echo 'nothing changed'
finemote generate robot.urdf -o out --force; echo "exit $?"
echo '// mine' >>out/buses.cpp
finemote generate robot.urdf -o out --force; echo "exit $?"
find out -type f | sort
cat out/buses.cpp.orig
finemote check robot.urdf -o out
