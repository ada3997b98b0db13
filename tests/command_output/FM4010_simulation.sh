cat >model.json <<'X'
{"model": {"tick_ns": 1, "devices": [
  {"name": "fast", "parent": null, "period_ns": 10, "update_wcet_ns": 9, "handle_wcet_ns": 0},
  {"name": "slow", "parent": null, "period_ns": 100, "update_wcet_ns": 9223372036854775807, "handle_wcet_ns": 0}
]}}
X
finemote simulate --duration 1us model.json
