cat >model.json <<'X'
{"model": {"tick_ns": 100, "device": []}}
X
finemote analyze model.json
