cat >r.urdf <<'X'
<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>
<device name="button" type="key" period="5ms"><use role="line" pin="key"/></device></finemote></robot>
X
sed -i 's#pin="key"/>#&<wcet update="10ns" handle="10ns"/>#' r.urdf
finemote wcet r.urdf -o r.timing.json >table
finemote analyze r.urdf 2>&1 >table | sed -E 's/[0-9.]+ ?[nu]s/TIME/g'; exit ${PIPESTATUS[0]}
