robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote -q generate robot.urdf -o out
echo '{' >out/finemote.manifest.json
finemote generate robot.urdf -o out
