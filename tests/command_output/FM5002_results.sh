# a file that a command ends with and cannot write is found before the work: nothing is compiled, run or kept
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
mkdir folder
finemote=$(command -v finemote)
refused() { echo "> $*" >&2; PATH=/nonexistent "$finemote" "$@"; echo "exit $?" >&2; }
refused run robot.urdf --keep kept --json missing/run.json
refused run robot.urdf --keep kept --json missing/run.json --audit missing/deeper/audit.jsonl -o folder
refused run robot.urdf --keep kept -o robot.urdf/trace.json
refused run robot.urdf --keep kept --json kept.json/run.json
refused run robot.urdf --keep kept --json kept/../missing/run.json
refused wcet robot.urdf -o missing/robot.timing.json
refused wcet robot.urdf -o robot.urdf
refused report robot.urdf -o missing/report.html
refused simulate robot.urdf --duration 20ms -o missing/trace.json
ls
# the folder that --keep makes is no reason: the compiler is what is missing
refused run robot.urdf --keep kept --json kept/run.json 2>&1 | grep -o 'FM[0-9]*' >&2
ls; ls kept
