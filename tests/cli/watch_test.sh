#!/usr/bin/env bash
# watch_test.sh FINEMOTE: `check --watch` answers again after each change of what it depends on, and only then.
set -euo pipefail
finemote=$(realpath "$1")
work=$(mktemp -d)
trap 'kill "${watcher:-}" 2>/dev/null || true; rm -rf "$work"' EXIT
cd "$work"

fail() { printf 'FAILED %s\n' "$*"; cat said errors; exit 1; }

# answered WHAT PATTERN: one more answer comes, and its lines, which the one that says "watching" ends, hold the pattern.
answered() {
  answers=$((answers + 1))
  for _ in $(seq 300); do
    [ "$(grep -c '^watching' errors || true)" -lt $answers ] || break
    sleep 0.1
  done
  [ "$(grep -c '^watching' errors || true)" -eq $answers ] || fail "$1: not $answers answers"
  { tail -n +$((said_before + 1)) said; tail -n +$((errors_before + 1)) errors; } >answer
  grep -q -- "$2" answer || fail "$1: no '$2' in: $(cat answer)"
  said_before=$(wc -l <said) errors_before=$(wc -l <errors)
}

# For a watcher, which empties its files some time after it was started: counts of answers so far, and of their lines in each file.
begin_anew() {
  answers=0 said_before=0 errors_before=0
  : >said
  : >errors
}

begin_anew
mkdir devices
robot() {
  printf '<robot name="r"><finemote version="1"><board name="robomaster_type_c"/>
    <device name="load" type="sim_load" period="%s"><wcet update="9us" handle="9us"/></device></finemote></robot>\n' "$1" >robot.new
  mv robot.new robot.urdf  # at once: half a file would be a change, too
}
robot 10ms
"$finemote" -q generate robot.urdf -o out
"$finemote" check robot.urdf -o out --watch >said 2>errors &
watcher=$!
answered "the first answer" fresh
robot 20ms
answered "another period" "because 'robot.urdf' changed"
"$finemote" -q generate robot.urdf -o out
answered "generated anew" fresh
echo '// mine' >>out/buses.cpp
answered "an edited file" 'hand-edited .*buses.cpp'
echo '{ "board": "host" }' >settings.new
mv settings.new finemote.json
answered "settings that came" 'generate .* --board host'
robot 20
answered "a mistake" 'FM3030'
robot 20ms
answered "mended" 'hand-edited'
sleep 1  # ten times as long as it waits between two looks
[ "$(grep -c '^watching' errors)" -eq $answers ] || fail "answers without a change"
kill -0 $watcher || fail "it ended by itself"
! "$finemote" check - -o out --watch <robot.urdf 2>/dev/null || fail "standard input was watched"
! "$finemote" check robot.urdf -o out --watch --sandbox 2>/dev/null || fail "--watch beside --sandbox"
kill $watcher

# What is asked for and missing may come.
begin_anew
mkdir parts
printf '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="parts/load.xacro"/>
  <finemote version="1"><board name="robomaster_type_c"/></finemote></robot>\n' >with_parts.xacro
"$finemote" check with_parts.xacro -o parts_out --watch >said 2>errors &
watcher=$!
answered "without the included file" 'FM1027'
printf '<robot><finemote><device name="load" type="sim_load" period="10ms"/></finemote></robot>\n' >parts/load.xacro
answered "the included file came" 'missing .*buses.cpp'
kill $watcher

# A report is written again, and a mistake leaves the page as it was.
begin_anew
robot 10ms
"$finemote" report robot.urdf -o page.html --watch >said 2>errors &
watcher=$!
answered "the first page" 'written: page.html'
grep -q 'every 10ms' page.html || fail "not the page of the robot"
robot 20ms
answered "another page" 'written: page.html'
grep -q 'every 20ms' page.html || fail "not the page of the robot as it is now"
cp page.html page.before
robot 20
answered "a mistake in the robot" 'FM3030'
cmp -s page.html page.before || fail "a mistake changed the page"
kill -0 $watcher || fail "the watch of the report ended by itself"
echo "$answers answers"
