#!/usr/bin/env bash
# run_stories.sh FINEMOTE: broken robots as they are written in a hurry. For each, what the tool says is what stands in `said`,
# and what somebody made of that alone, in `mended/`, generates without a word. FINEMOTE_UPDATE_GOLDEN=1 rewrites `said`.
set -u
finemote=$(realpath "$1")
cd "$(dirname "$0")"
failed=0
passed=0
fail() { echo "FAILED $*"; failed=$((failed + 1)); }
generate() { (cd "$1" && "$finemote" -q generate robot.urdf* -o out); }

for robot in [0-9]*/; do
  robot=${robot%/}
  folder=$(mktemp -d)
  cp -r "$robot/." "$folder"
  generate "$folder" >"$folder/now" 2>&1
  [ $? -eq 2 ] || fail "$robot: the broken robot is taken"
  if [ "${FINEMOTE_UPDATE_GOLDEN:-}" = 1 ]; then cp "$folder/now" "$robot/said"; fi
  diff "$robot/said" "$folder/now" || fail "$robot: other words"
  cp -r "$robot/mended/." "$folder"
  generate "$folder" >"$folder/now" 2>&1 || fail "$robot: not mended"
  [ ! -s "$folder/now" ] || { fail "$robot: still says"; cat "$folder/now"; }
  rm -rf "$folder"
  passed=$((passed + 1))
done
echo "$passed robots, $failed failed"
[ $failed -eq 0 ] && [ $passed -ge 10 ]
