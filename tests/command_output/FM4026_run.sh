cat >r.urdf <<'X'
<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>
<device name="button" type="key" period="5ms"><use role="line" pin="key"/></device></finemote></robot>
X
echo '{"schema": "finemote.run/1"}' >r.timing.json
finemote analyze r.urdf
