# a run that was held to other bounds
robot <<'Y'
    <device name="load" type="sim_load" period="10ms"><wcet update="20us" handle="20us" source="budget"/></device>
Y
bound=$(finemote analyze robot.urdf --format json | sed -nE 's/.*"decide_ns": ([0-9]+).*/\1/p' | head -1)
run() {
  echo "{\"schema\": \"finemote.run/1\", \"chains\": [{\"from\": \"load\", \"to\": \"load\", \"decide\": {\"max_ns\": 30000, \"bound_ns\": $1, \"judged\": \"held\"}, \"wire\": {\"bound_ns\": null}}]}" > run.json
}
run "$bound"
finemote report robot.urdf -o page.html --run run.json; echo "exit $?"
run 61000
finemote report robot.urdf -o page.html --run run.json; echo "exit $?"
finemote -W error report robot.urdf -o page.html --run run.json; echo "exit $?"
