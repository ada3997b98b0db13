#!/usr/bin/env bash
# run_cases.sh FINEMOTE SOURCE quick|slow [FOLDER [PATTERN]]: runs cases of FOLDER (this one) and compares all they say with
# the files beside them. `slow` runs those whose names end in _slow, `quick` all others: every case is run by one of the two,
# whatever it is called. A case FMnnnn_name.sh is a few commands, run in an empty folder; FMnnnn_name.expected holds what comes
# on stderr, then on stdout if anything does, then the exit status. The number must be among what is said.
# FINEMOTE_UPDATE_GOLDEN=1 rewrites.
set -u
. "$(dirname "$0")/../common.sh"
finemote=$(realpath "$1")
source=$(realpath "$2")
selection=$3
cases=$(cd "${4:-$(dirname "$0")}" && pwd)
pattern=${5:-*}
PATH=$(dirname "$finemote"):$PATH
export source cases
failed=0
passed=0

# robot.urdf with a board and what comes on stdin inside <finemote>
robot() {
  { printf '<robot name="rover">\n  <link name="base_link"/>\n  <finemote version="1">\n    <board name="robomaster_type_c"/>\n'
    cat
    printf '  </finemote>\n</robot>\n'; } >robot.urdf
}
# robot.urdf.xacro with what comes on stdin inside <robot>
xacro_robot() {
  { printf '<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'; cat; printf '</robot>\n'; } >robot.urdf.xacro
}
# a device type `probe` whose class has the members on stdin, and a robot with one of it
probe_robot() {
  mkdir devices
  { printf '#pragma once\n#include <finemote/contract.hpp>\n#include <finemote/time.hpp>\n'
    cat; } >devices/probe.hpp
  printf '{ "schema": "finemote.device/1", "type": "probe", "summary": "for tests", "class": "Probe", "header": "probe.hpp",\n' >devices/probe.json
  printf '  "provides": [], "constant_init": %s, "wcet": { "update_ns": 2000, "handle_ns": 1000 } }\n' "${1:-true}" >>devices/probe.json
  robot <<'X'
    <device name="probe" type="probe" period="10ms"/>
X
}
# joint NAME TYPE PARENT CHILD XYZ AXIS [LOWER UPPER]: the link CHILD and the joint it hangs on
joint() {
  printf '  <link name="%s"/>\n  <joint name="%s" type="%s">\n' "$4" "$1" "$2"
  printf '    <parent link="%s"/>\n    <child link="%s"/>\n' "$3" "$4"
  printf '    <origin xyz="%s"/>\n    <axis xyz="%s"/>\n' "$5" "$6"
  [ $# -eq 6 ] || printf '    <limit lower="%s" upper="%s" effort="1" velocity="5"/>\n' "$7" "$8"
  printf '  </joint>\n'
}
# robot.urdf with a board, the links and joints of $1, and what comes on stdin inside <finemote>
jointed_robot() {
  { printf '<robot name="r">\n  <link name="base_link"/>\n%s\n' "$1"
    printf '  <finemote version="1">\n    <board name="robomaster_type_c"/>\n'
    cat
    printf '  </finemote>\n</robot>\n'; } >robot.urdf
}
# timed_button ARGUMENTS HASH: the robot r.urdf with one device, and its timing file, as if of these (JSON)
timed_button() {
  cat >r.urdf <<'X'
<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>
<device name="button" type="key" period="5ms"><use role="line" pin="key"/></device></finemote></robot>
X
  cat >r.timing.json <<X
{"schema": "finemote.wcet/1",
 "stages": [{"device": "button", "stage": "update", "wcet_ns": 4000}, {"device": "button", "stage": "handle", "wcet_ns": 0}],
 "model": {"name": "cortex-m4-maxima", "version": 1, "placement": "flash"},
 "inputs": {"compiler": null, "options": {"board": null}, "arguments": $1, "hash": $2}}
X
}
# the expander `pwm` on the bus `i2c`
pwm_expander() {
  printf '    <bus name="i2c" type="i2c" port="i2c2"/>\n'
  printf '    <expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>\n'
}
# hull_type [AXIS...]: a device type `hull` with thrusters, which commands these axes of the wrench, or all
hull_type() {
  local axes=
  [ $# -eq 0 ] || axes=$(printf ', "%s"' "$@")
  mkdir -p devices
  printf '#pragma once\n' >devices/hull.hpp
  cat >devices/hull.json <<X
{ "schema": "finemote.device/1", "type": "hull", "summary": "pushes", "class": "Hull", "header": "hull.hpp",
  "roles": [{ "name": "thrusters", "interface": "Thruster", "min": 1 }],
  "geometry": [{ "kind": "allocation", "role": "thrusters"${axes:+, \"commands\": [${axes#, }]} }],
  "wcet": { "update_ns": 1000, "handle_ns": 1000 } }
X
}
# hull JOINT...: a device of this type with one thruster at each joint
hull() {
  local channel=0 joint
  printf '    <device name="hull" type="hull" period="20ms">\n'
  for joint in "$@"; do
    printf '      <device name="t%s_hull" type="pwm_esc" bus="pwm" channel="%s" joint="%s"/>\n' $channel $channel "$joint"
    channel=$((channel + 1))
  done
  printf '    </device>\n'
}
export -f as_somebody timed_button robot xacro_robot probe_robot joint jointed_robot pwm_expander hull_type hull

say() {  # the whole answer of one case
  local status=0
  (cd "$1" && bash "$2") >"$1.out" 2>"$1.err" </dev/null || status=$?
  cat "$1.err"
  [ ! -s "$1.out" ] || { echo '-- stdout'; cat "$1.out"; }
  echo "-- exit $status"
}

# the names of all cases of the selection, by their scripts or their answers: neither may be without the other
names() {
  local file name
  for file in "$cases"/*.sh "$cases"/*.expected; do
    name=$(basename "${file%.*}")
    case $selection:$name in *:run_cases | quick:*_slow) continue ;; slow:*_slow | quick:*) echo "$name" ;; esac
  done | grep -v '^\*$' | sort -u
}

for name in $(names); do
  case $name in $pattern) ;; *) continue ;; esac
  script=$cases/$name.sh
  [ -e "$script" ] || { echo "FAILED $name: there is no $name.sh"; failed=$((failed + 1)); continue; }
  folder=$(mktemp -d)
  mkdir "$folder/work"
  say "$folder/work" "$script" >"$folder/said"
  sed -i "s#$source#SOURCE#g; s#$folder/work#FOLDER#g; s#$(dirname "$finemote")#BUILD#g" "$folder/said"
  if [ "${FINEMOTE_UPDATE_GOLDEN:-}" = 1 ]; then cp "$folder/said" "$cases/$name.expected"; fi
  code=${name:0:6}
  good=yes
  cmp -s "$folder/said" "$cases/$name.expected" || { echo "FAILED $name"; diff "$cases/$name.expected" "$folder/said"; good=no; }
  case $code in
    FM????) grep -q "\[$code\]" "$folder/said" || { echo "FAILED $name: says no $code"; good=no; } ;;
  esac
  if [ $good = yes ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  rm -rf "$folder"
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ] && [ $passed -gt 0 ]
