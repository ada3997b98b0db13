#!/usr/bin/env bash
# Every example has a timing file, which is what finemote wcet computes by the compiler that it names, and declares no
# time: all that an analysis takes is static.
# Arguments: finemote, the sources. FINEMOTE_UPDATE_GOLDEN=1 writes them.
set -euo pipefail
finemote=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
compiler_of() { sed -n 's/.*"compiler": "\(.*\)",*/\1/p' "$1"; }

fail() {
  echo "FAILED $*"
  exit 1
}

robots=0
for robot in "$source"/examples/*.urdf; do
  name=$(basename "$robot" .urdf)
  kept=$source/examples/$name.timing.json
  "$finemote" wcet "$robot" -o "$folder/$name.json" >/dev/null || fail "$name: something has no bound"
  if [ "${FINEMOTE_UPDATE_GOLDEN:-}" = 1 ]; then
    cp "$folder/$name.json" "$kept"
  elif [ ! -e "$kept" ]; then
    fail "$name has no timing file: ./dev golden"
  elif [ "$(compiler_of "$folder/$name.json")" != "$(compiler_of "$kept")" ]; then
    echo "$name: computed with $(compiler_of "$kept"), which is not here"
  else
    diff "$kept" "$folder/$name.json" | head -20
    cmp "$kept" "$folder/$name.json" || fail "$name: its timing file is out of date: ./dev golden"
  fi
  ! grep '<wcet' "$robot" || fail "$name declares a time"
  "$finemote" analyze "$robot" --require-static >/dev/null || fail "$name: not static, or not schedulable"
  robots=$((robots + 1))
done
[ $robots -ge 7 ] || fail "only $robots examples"
"$finemote" analyze "$source/examples/finsrov.urdf.xacro" --require-static >/dev/null || fail "finsrov.urdf.xacro is another robot"
[ "$(ls "$source"/examples/*.timing.json | wc -l)" = $robots ] || fail "a timing file is of no robot"
echo "$robots timing files"
