cat >model.json <<'X'
{"model": {"tick_ns": 1, "devices": [
  {"name": "d0", "parent": "d1", "period_ns": 9999991, "update_wcet_ns": 1000, "handle_wcet_ns": 1000},
  {"name": "d1", "parent": null, "period_ns": 10000019, "update_wcet_ns": 1000, "handle_wcet_ns": 1000}
]}}
X
finemote analyze model.json >/dev/null
