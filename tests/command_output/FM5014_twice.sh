# two outputs of one command are two files
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
X
refused() { "$@"; echo "exit $?"; }
refused finemote generate robot.urdf -o out --depfile out/schedule.cpp
finemote -q generate robot.urdf -o out
ln -s schedule.cpp out/link.d
for file in finemote.manifest.json trees/../schedule.cpp link.d; do
  refused finemote generate robot.urdf -o out --depfile out/$file
done
finemote -q simulate robot.urdf --duration 20ms -o both.json >both.json; echo "exit $?"
refused finemote run robot.urdf --keep work -o work/generated/buses.cpp
refused finemote run robot.urdf --keep work -o work/build/../build/firmware.elf
finemote -q check robot.urdf -o out
ls work 2>/dev/null
finemote -q simulate robot.urdf --duration 20ms -o /dev/stdout >one.json; echo "exit $?"
finemote -q generate robot.urdf -o out --depfile out/robot.d; echo "exit $?"
