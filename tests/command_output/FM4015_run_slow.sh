robot <<'B'
    <device name="slow" type="sim_load" period="10ms"><wcet update="6ms" handle="5ms"/></device>
    <require latency="slow -> slow" of="decision" max="1ms"/>
B
finemote run robot.urdf --board host --duration 20ms --format json >out.json
echo "status $?: $(grep -o '"schedulable": [a-z]*' out.json)"
finemote run robot.urdf --board host --duration 20ms --allow-unschedulable 2>/dev/null | grep ^schedulable
echo "allowed: ${PIPESTATUS[0]}"
