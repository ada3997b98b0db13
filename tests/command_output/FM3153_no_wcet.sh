robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote lint robot.urdf
