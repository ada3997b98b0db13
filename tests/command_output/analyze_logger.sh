# No chain leads from the inputs of a logger, and none through a tree that holds nothing else.
mkdir devices
echo '#pragma once' >devices/logger.hpp
cat >devices/logger.json <<'X'
{ "schema": "finemote.device/1", "type": "logger", "summary": "keeps what it hears", "class": "Logger", "header": "logger.hpp",
  "provides": [{ "interface": "my::Log", "command": true }],
  "roles": [{ "name": "inputs", "interface": "any", "min": 1, "passes": false }],
  "wcet": { "update_ns": 1000, "handle_ns": 1000 } }
X
robot <<'X'
    <device name="top" type="group" period="10ms">
      <device name="log" type="logger">
        <device name="key" type="key"><use role="line" pin="key"/></device>
      </device>
    </device>
X
for command in analyze check generate lint simulate; do
  case $command in
    check | generate) finemote -q $command robot.urdf -o out >said 2>&1 ;;
    simulate) finemote -q $command robot.urdf --duration 20ms >said 2>&1 ;;
    *) finemote -q $command robot.urdf >said 2>&1 ;;
  esac
  echo "$command: $?"
done
finemote -q analyze robot.urdf | sed -n '/^chains/,/^$/p'
