#!/usr/bin/env bash
# demo_test.sh FINEMOTE FOLDER: what `./dev demo` prints is the result alone, the same on every run, and ends as the README says.
set -euo pipefail
finemote=$1
cd "$(dirname "$0")/.."
rm -rf "$2" && mkdir -p "$2"
work=$(cd "$2" && pwd)

fail() { echo "FAIL: $1"; exit 1; }

for n in 1 2; do
  tests/demo.sh "$finemote" "$work/demo" >"$work/$n" 2>"$work/progress"
  rm -rf "$work/demo/type_c"
done
cmp "$work/1" "$work/2" || fail "another result the second time"
for heading in 'The robot' 'The Type C image' 'The image on the emulated board' 'In short'; do
  grep -q "^== $heading" "$work/1" || fail "no '$heading'"
done
for progress in generating compiling running; do
  grep -q "^$progress" "$work/progress" || fail "no '$progress' as progress"
  ! grep -q "^$progress" "$work/1" || fail "'$progress' in the result"
done
[ "$(sed '1,/^== In short/d' "$work/1" | grep -vc '^to look at:')" = 10 ] || fail "not ten lines in short"
[ "$(tail -n 1 "$work/1")" = "to look at: $work/demo/report.html" ] || fail "the name of the report"
grep -q '<html' "$work/demo/report.html" || fail "the report"
