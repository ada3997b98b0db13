robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
mkdir real
ln -s real out
finemote generate robot.urdf -o out
