#!/usr/bin/env bash
# run_examples.sh FINEMOTE SOURCE: runs the wrong and the right example of every page in docs/diagnostics. The wrong one has to
# produce the code of the page; with the right one nothing may be an error. A fragment is put into a small robot: frames.sh says
# how, where what is done here for all does not do.
set -u
. "$(dirname "$0")/../common.sh"
finemote=$(realpath "$1")
source=$(realpath "$2")
PATH=$(dirname "$finemote"):$PATH
export source
here=$(cd "$(dirname "$0")" && pwd)

# Pages whose examples stand for something that cannot be run in a moment: their codes have cases in tests/command_output and
# tests/unit.
not_run='FM0005 FM0006 FM0007 FM0009 FM0010 FM2016 FM3205 FM5005 FM6001 FM6002 FM6003 FM6004 FM6005 FM6006 FM6007 FM6009 FM6010 FM6011 FM6012 FM6013 FM6014 FM6015 FM6016 FM6017 FM6101 FM6102 FM6103 FM6104 FM6105 FM6106 FM6107 FM9001'

# A period for the devices of a page that shows none at all: it is about something else.
with_periods() { has 'period=' || example=${example//<device /<device period=\"100ms\" }; }

# the block behind "Wrong:" or "Right:" of a page
block() {
  awk -v word="$2" '$0 ~ "^" word { found = 1; next } found && /^```/ { if (inside) exit; inside = 1; next } inside' "$1"
}

# The program, as every example calls it: how each run ended is kept. $become are words before it.
become=()
finemote() {
  local status=0
  "${become[@]}" "$finemote" "$@" || status=$?
  echo "$status: finemote $*" >>"$folder.ended"
  return $status
}

has() { grep -qF -- "$1" <<<"$example"; }
# supply NAME LINE: a bus the example names and does not have
supply() {
  has "bus=\"$1\"" && ! has "<bus name=\"$1\"" && ! has "<expander name=\"$1\"" && ! has "<channel index=\"0\" name=\"$1\"" && echo "$2"
}
buses() {
  supply imu_uart '<bus name="imu_uart" type="uart" port="usart1" baud="921600baud"/>'
  supply serial '<bus name="serial" type="uart" port="usart6" baud="921600baud"/>'
  supply serial_a '<bus name="serial_a" type="uart" port="usart1" baud="921600baud"/>'
  supply serial_b '<bus name="serial_b" type="uart" port="usart6" baud="921600baud"/>'
  supply uart_1 '<bus name="uart_1" type="uart" port="usart1" baud="921600baud"/>'
  supply uart_2 '<bus name="uart_2" type="uart" port="usart6" baud="921600baud"/>'
  supply tether '<bus name="tether" type="uart" port="usart6" baud="460800baud"/>'
  supply can '<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>'
  supply i2c '<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>'
  supply pwm '<bus name="driver" type="i2c" port="i2c3"/><expander name="pwm" model="pca9685" bus="driver" address="0x40"/>'
}
load='<device name="load" type="sim_load" period="10ms"/>'
# finemote_block TEXT: a robot whose extension holds it, and a device if it has none
finemote_block() {
  printf '<robot name="rover">\n  <link name="base_link"/>\n  <finemote version="1">\n'
  has '<board' || echo '    <board name="robomaster_type_c"/>'
  buses
  printf '%s\n' "$1"
  case $1 in *'<device '*) ;; *) echo "    $load" ;; esac
  printf '  </finemote>\n</robot>\n'
}
robot() { finemote_block "${1:-$example}" >robot.urdf; }
links() { printf '<robot name="rover">\n%s\n  <finemote version="1">\n    <board name="robomaster_type_c"/>\n    %s\n  </finemote>\n</robot>\n' "$1" "${2:-$load}" >robot.urdf; }
xacro_robot() { printf '<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">\n%s\n</robot>\n' "${1:-$example}" >robot.urdf.xacro; }
ask() { finemote lint robot.urdf; }
# a device type `servo` of the user's, whose descriptor has the members on stdin beside those every one has
servo() {
  mkdir -p devices
  echo '#pragma once' >devices/servo.hpp
  { printf '{ "schema": "finemote.device/1", "type": "servo", "summary": "x", "class": "Servo", "header": "servo.hpp"'; cat; echo ' }'; } >devices/servo.json
  example='<device name="servo" type="servo" period="10ms"/>' robot '<device name="servo" type="servo" period="10ms"/>'
}
# a timing model with these members beside a good device, or a device with these members
model() { printf '{"model": {%s}}' "$1" >model.json; finemote analyze model.json; }
one_device='"devices": [{"name": "a", "parent": null, "period_ns": 10000000, "update_wcet_ns": 4000, "handle_wcet_ns": 4000}]'

default_frame() {
  case $code:$example in
    FM10*) xacro_robot; finemote xacro robot.urdf.xacro ;;
    *:'<robot'*) echo "$example" >robot.urdf; ask ;;
    *:'<finemote'*) links '<link name="base_link"/>'; sed -i '/<finemote/,/<\/finemote>/d' robot.urdf; sed -i "s#</robot>##" robot.urdf; { echo "$example"; has '</finemote>' || echo '</finemote>'; echo '</robot>'; } >>robot.urdf; ask ;;
    FM40*) robot; finemote analyze robot.urdf ;;
    *) with_periods; robot; ask ;;
  esac
}
. "$here/frames.sh"

passed=0
failed=0
# run_example PAGE Wrong|Right: what is said of it
run_example() {
  which=$2
  example=$(block "$1" "$2")
  [ -n "$example" ] || { echo "no example"; return; }
  if declare -F "frame_$code" >/dev/null; then "frame_$code"; else default_frame; fi
}
# Whether what was said is what the page tells. 3 and a signal are no answer to any example.
is_as_told() {
  [ -s "$folder.ended" ] && ! grep -v '^[012]:' "$folder.ended" || return 1
  case $which in
    Wrong) grep -q "\[$code\]" <<<"$said" ;;
    Right) ! grep -qE "error\[|\[$code\]" <<<"$said" ;;
  esac
}
check() {  # PAGE
  code=$(basename "$1" .md)
  case " $not_run " in *" $code "*) return ;; esac
  for which in Wrong Right; do
    folder=$(mktemp -d)
    said=$(cd "$folder" && run_example "$1" $which 2>&1 </dev/null)
    if is_as_told; then
      passed=$((passed + 1))
    else
      failed=$((failed + 1))
      printf 'FAILED %s %s: %s\n' "$code" "$which" "$said" | head -12
    fi
    rm -rf "$folder" "$folder.ended"
  done
}
for page in "$source"/docs/diagnostics/${3:-FM????}.md; do check "$page"; done
echo "$passed examples as their pages say, $failed not"
[ $failed -eq 0 ] && [ $passed -gt 0 ]
