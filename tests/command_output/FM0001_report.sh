robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
echo "== an output, and a robot"
finemote report robot.urdf
finemote report "$source/tests/analysis-cases/single-bus.json" -o page.html
finemote graph robot.urdf --format png
finemote graph missing.urdf
echo "== a run that is none"
finemote report robot.urdf -o page.html --run missing.json
echo '{"schema": "finemote.run/1", "chains": [' > cut.json
finemote report robot.urdf -o page.html --run cut.json
echo '["finemote.run/1"]' > list.json
finemote report robot.urdf -o page.html --run list.json
echo '{"schema": "finemote.run/1", "chains": [{"from": "nobody", "to": 5}]}' > other.json
finemote report robot.urdf -o page.html --run other.json
echo "== over what it reads"
finemote report robot.urdf -o robot.urdf
echo '{"schema": "finemote.run/1", "chains": [3, {"from": 7, "ages": {"t_ns": [1, 2], "age_ns": [-5, 1e308, 4]}, "end_to_end": {"max_ns": 1, "bound_ns": "x"}}], "image": [], "stages": {}, "values": [7, {"part": 3, "values": ["x", null, 1e308, -1e308]}, {"from_ns": 1e300, "every_ns": {}, "values": [1.5, 2.5]}, {"unit": "m", "values": 4}], "expectations": [0, {"min": []}]}' > odd.json
finemote report robot.urdf -o odd.json --run odd.json
finemote report robot.urdf -o nowhere/page.html
finemote -q report robot.urdf -o page.html --run odd.json && ls
