cat >model.json <<'X'
{"model": {"tick_ns": 100, "devices": []}}
X
finemote analyze model.json
