#!/usr/bin/env bash
# bench.sh BUILD_DIR: the figures of the design, measured as ratios and instruction counts, beside what is to be reached.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "${1:?usage: bench.sh BUILD_DIR}" && pwd)
finemote=$build/finemote

echo "== scheduling overhead of a ROV with 14 devices per 10 ms, in instructions (to reach: 150; dispatch of a stage: 4)"
"$here/overhead.sh" "$build/bench-overhead" 2>/dev/null

echo
echo "== FinsROV image for the Type C board (to reach: 16384 B flash, 3584 B RAM without a copy of the code)"
"$finemote" run "$root/examples/finsrov.urdf" --build-only

echo
echo "== generate FinsROV from xacro, whole process, milliseconds of processor time (to reach: 10)"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
TIMEFORMAT='%U %S'
best=
for _ in 1 2 3 4 5 6 7 8 9 10; do
  used=$( { time "$finemote" -q generate "$root/examples/finsrov.urdf.xacro" -o "$folder/out" >/dev/null; } 2>&1 | awk '{ printf "%d", 1000 * ($1 + $2) }')
  if [ -z "$best" ] || [ "$used" -lt "$best" ]; then best=$used; fi
done
echo "best of 10: $best ms"

echo
echo "== xacro (to reach: 20,000 macro calls within 1 s of processor time, linear)"
"$build/tests/bench/xacro/xacro_bench"

echo
echo "== timing analysis (to reach: 10,000 devices within 0.3 s; bound / worst simulated as in the design)"
"$build/tests/bench/timing/timing_bench"

echo
echo "== report of 1,000 devices, whole process, milliseconds of processor time (to reach: 1000), and its size (to reach: 2000000 B)"
{
  printf '<robot name="wide"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>'
  printf '<device name="root" type="group" period="40ms">'
  for leaf in $(seq 999); do printf '<device name="leaf_%s" type="sim_load"/>' "$leaf"; done
  printf '</device></finemote></robot>'
} >"$folder/wide.urdf"
used=$( { time "$finemote" -q report "$folder/wide.urdf" -o "$folder/wide.html" >/dev/null 2>&1; } 2>&1 | awk '{ printf "%d", 1000 * ($1 + $2) }')
echo "$used ms, $(stat -c %s "$folder/wide.html") B"

echo
echo "== emulator speed on the infantry (to reach: 50 M instructions per second of processor time)"
"$finemote" -q run "$root/examples/infantry.urdf" --build-only --keep "$folder/infantry" >/dev/null
"$build/tests/bench/emulator/emulator_speed" "$folder/infantry/build/firmware.elf" "$folder/infantry/parts.json" 5

echo
echo "== measured beside bound on the emulated board, all chains of all examples; no measured value may be above its bound"
for robot in "$root"/examples/*.urdf "$root"/examples/*.urdf.xacro; do
  echo "-- ${robot##*/}"
  "$finemote" run "$robot" -v --duration 1s | sed -n '/^age of/,/^$/p'
done
