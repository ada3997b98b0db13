#!/usr/bin/env bash
# demo.sh FINEMOTE FOLDER: FinsROV from its URDF to a measured run. Stdout is the result alone, the same on every run;
# progress goes to stderr.
set -euo pipefail
finemote=$1
folder=$2
robot=examples/finsrov.urdf

printf 'generating %s\n' "$robot" >&2
"$finemote" generate "$robot" -o "$folder/generated" >&2

echo "== The robot"
"$finemote" tree "$robot"

echo
echo "== The Type C image"
printf 'compiling for the Type C board\n' >&2
"$finemote" run "$robot" --build-only --keep "$folder/type_c"

echo
echo "== The image on the emulated board, with models of the robot's parts on its buses"
printf 'running the image\n' >&2
"$finemote" run "$robot" -v --keep "$folder/type_c" --duration 1s

echo
echo "== In short: it dives to 0.75 m, turns to 45 degrees, is pushed away, and comes back"
scenario=tests/emulator/scenarios/rov_loops.json
printf 'running %s, and writing a report\n' "$scenario" >&2
"$finemote" run "$robot" --keep "$folder/type_c" --scenario "$scenario" --duration 14s --json "$folder/run.json" | sed '/^$/,$d'
"$finemote" -q report "$robot" --run "$folder/run.json" -o "$folder/report.html" >&2
echo "to look at: $folder/report.html"
