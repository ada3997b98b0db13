robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote=$(command -v finemote)
mkdir bin
for tool in cmake ninja c++; do ln -s "$(command -v $tool)" bin/$tool; done
PATH=$PWD/bin "$finemote" run robot.urdf --board qemu_f405
rm bin/ninja
PATH=$PWD/bin "$finemote" run robot.urdf
