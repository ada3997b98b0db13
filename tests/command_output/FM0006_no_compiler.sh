robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote=$(command -v finemote)
PATH=/nonexistent "$finemote" run robot.urdf --board host
