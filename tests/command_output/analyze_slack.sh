# 2 ms of work every 10 ms, half of it by each device: five times as much fits, or nine times as much of one of them. Without
# --slack there is no word of it.
cat >model.json <<'X'
{"model": {"tick_ns": 1000, "devices": [
  {"name": "arm", "parent": null, "period_ns": 10000000, "update_wcet_ns": 600000, "handle_wcet_ns": 400000},
  {"name": "leg", "parent": null, "period_ns": 10000000, "update_wcet_ns": 1000000, "handle_wcet_ns": 0}]}}
X
finemote analyze model.json --slack | sed -n '/^slack/,$p'
finemote analyze model.json --slack --format json | python3 -c 'import json, sys; print(json.load(sys.stdin)["slack"])'
for format in text json; do finemote analyze model.json --format $format | grep -q slack || echo "$format: no word of it"; done
