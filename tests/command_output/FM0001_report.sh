cp "$source/examples/two_devices.urdf" robot.urdf
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
echo '{"schema": "finemote.run/1", "chains": [3, {"from": 7}], "image": [], "stages": {}}' > odd.json
finemote report robot.urdf -o odd.json --run odd.json
finemote report robot.urdf -o nowhere/page.html
finemote -q report robot.urdf -o page.html --run odd.json && ls
