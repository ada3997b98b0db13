# the command that check prints makes the files fresh, whatever options they depend on
mkdir -p "a b/devices" 'it'"'"'s/urdf' own
cat >"a b/r.urdf.xacro" <<'X'
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="note" default="x"/>
  <xacro:include filename="$(find other)/urdf/part.xacro"/><!-- $(arg note) -->
  <finemote version="1"><board name="robomaster_type_c"/><device name="probe" type="probe" period="10ms"/></finemote>
</robot>
X
echo '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base_link"/></robot>' >"it's/urdf/part.xacro"
echo '#pragma once' >own/probe.hpp
echo '{ "schema": "finemote.device/1", "type": "probe", "summary": "for tests", "class": "Probe", "header": "probe.hpp", "provides": [], "wcet": { "update_ns": 2000, "handle_ns": 1000 } }' >own/probe.json
options=(--package "other=$PWD/it's" --device-path own --board host 'note:=$HOME `x`')
finemote -q check "a b/r.urdf.xacro" -o 'out"put' "${options[@]}"
finemote check "a b/r.urdf.xacro" -o 'out"put' "${options[@]}" 2>&1 >/dev/null | sed -n 's/^run: //p' >pasted
cat pasted
bash pasted; echo "exit $?"
finemote check "a b/r.urdf.xacro" -o 'out"put' "${options[@]}"; echo "exit $?"
robot <<'X'
    <device name="load" type="sim_load" period="10ms"><wcet update="20ms" handle="20us" source="budget"/></device>
X
finemote check robot.urdf -o out 2>&1 >/dev/null | grep run:
