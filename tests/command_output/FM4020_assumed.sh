robot <<'X'
    <device name="base" type="sim_load" period="10ms"/>
X
finemote -q analyze robot.urdf >/dev/null
