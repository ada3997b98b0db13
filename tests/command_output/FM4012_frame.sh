cat >model.json <<'X'
{"model": {"tick_ns": 100, "buses": [
  {"name": "x", "baud_bps": 9000000000, "min_frame_bits": 1, "wcet_ns": 1}
], "devices": [
  {"name": "a", "parent": null, "period_ns": 1000, "update_wcet_ns": 4, "handle_wcet_ns": 4}
]}}
X
finemote analyze model.json
