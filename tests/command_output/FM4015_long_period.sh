cat >model.json <<'X'
{"model": {"tick_ns": 1, "devices": [
  {"name": "a", "parent": null, "period_ns": 100003, "update_wcet_ns": 21875, "handle_wcet_ns": 21875},
  {"name": "b", "parent": null, "period_ns": 100019, "update_wcet_ns": 28131, "handle_wcet_ns": 28131},
  {"name": "c", "parent": null, "period_ns": 9001980051300000000, "update_wcet_ns": 8505000037, "handle_wcet_ns": 8505000037}
]}}
X
finemote analyze model.json >/dev/null
