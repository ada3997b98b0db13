# The user chooses where outputs go, in the sandbox too: outside the folder of the input, but through no link in it.
mkdir robot out; cd robot
robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
cd ..
finemote generate robot/robot.urdf -o out/generated --depfile out/generated.d --sandbox -q; echo "generate: $?"
ls out out/generated; tr ' ' '\n' <out/generated.d | grep -c robot.urdf
finemote check robot/robot.urdf -o out/generated --sandbox; echo "check: $?"
finemote xacro robot/robot.urdf -o out/expanded.urdf --sandbox; echo "xacro: $?"; ls out
