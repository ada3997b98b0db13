mkdir devices
cp "$source"/tests/emulator/composite_wheels/devices/* devices
sed '/name="front_left"/s/ joint="[^"]*"//; /name="rear_left_motor"/s/ joint="[^"]*"//' "$source/tests/emulator/composite_wheels/robot.urdf" >robot.urdf
finemote=$(command -v finemote)
PATH=/nonexistent "$finemote" run robot.urdf
