robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote run robot.urdf --board arduino
finemote run robot.urdf --board qemu_f407
