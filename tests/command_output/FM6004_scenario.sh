robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
echo '{' >scenario.json
finemote run robot.urdf --scenario scenario.json
