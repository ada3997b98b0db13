# The robot's own board is the same as none: its timing file counts, as far as it is fresh.
cat >r.urdf <<'X'
<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>
<device name="button" type="key" period="5ms"><use role="line" pin="key"/></device></finemote></robot>
X
cat >r.timing.json <<'X'
{"schema": "finemote.wcet/1",
 "stages": [{"device": "button", "stage": "update", "wcet_ns": 4000}, {"device": "button", "stage": "handle", "wcet_ns": 0}],
 "model": {"name": "cortex-m4-maxima", "version": 1, "placement": "flash"},
 "inputs": {"compiler": null, "options": {"board": null}, "arguments": [], "hash": null}}
X
finemote analyze r.urdf --board robomaster_type_c >table
