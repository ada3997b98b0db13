cat >model.json <<'X'
{"model": {"tick_ns": 1, "devices": [
  {"name": "a", "parent": null, "period_ns": 100000, "update_wcet_ns": 25000, "handle_wcet_ns": 25000},
  {"name": "b", "parent": null, "period_ns": 1000000000, "update_wcet_ns": 250000000, "handle_wcet_ns": 249999999},
  {"name": "c", "parent": null, "period_ns": 9001980051300000000, "update_wcet_ns": 4000000037, "handle_wcet_ns": 4000000037}
]}}
X
finemote analyze model.json >/dev/null
