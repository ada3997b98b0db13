cat >model.json <<'X'
{"model": {"tick_ns": 1, "devices": [
  {"name": "a", "parent": null, "period_ns": 9223372036854775807, "update_wcet_ns": 9223372036854775807, "handle_wcet_ns": 9223372036854775807}
]}}
X
finemote analyze model.json
