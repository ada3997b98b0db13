#!/usr/bin/env bash
# run_cases.sh FINEMOTE SOURCE [PATTERN]: runs the cases (without PATTERN, those not named _slow) of this folder in an empty folder and compares all it says with the
# file beside it. A case FMnnnn_name.sh is a few commands; FMnnnn_name.expected holds what comes on stderr, then on stdout if
# anything does, then the exit status. The number must be among what is said. FINEMOTE_UPDATE_GOLDEN=1 rewrites.
set -u
finemote=$(realpath "$1")
source=$(realpath "$2")
cases=$(cd "$(dirname "$0")" && pwd)
PATH=$(dirname "$finemote"):$PATH
export source cases LC_ALL=C
unset NO_COLOR FINEMOTE_DATA ROS_PACKAGE_PATH AMENT_PREFIX_PATH
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
export -f robot xacro_robot probe_robot

say() {  # the whole answer of one case
  local status=0
  (cd "$1" && bash "$2") >"$1.out" 2>"$1.err" </dev/null || status=$?
  cat "$1.err"
  [ ! -s "$1.out" ] || { echo '-- stdout'; cat "$1.out"; }
  echo "-- exit $status"
}

for script in "$cases"/${3:-FM*[!w]}.sh; do
  name=$(basename "$script" .sh)
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
