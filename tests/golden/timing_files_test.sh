#!/usr/bin/env bash
# The timing files of the examples are those that finemote wcet computes, by the compiler that they name, and all that an
# analysis takes from them is static.
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

for kept in "$source"/examples/*.timing.json; do
  name=$(basename "$kept" .timing.json)
  "$finemote" wcet "$source/examples/$name.urdf" -o "$folder/$name.json" >/dev/null || fail "$name: something has no bound"
  if [ "${FINEMOTE_UPDATE_GOLDEN:-}" = 1 ]; then
    cp "$folder/$name.json" "$kept"
  elif [ "$(compiler_of "$folder/$name.json")" != "$(compiler_of "$kept")" ]; then
    echo "$name: computed with $(compiler_of "$kept"), which is not here"
  else
    diff "$kept" "$folder/$name.json" | head -20
    cmp "$kept" "$folder/$name.json" || fail "$name: its timing file is out of date: ./dev golden"
  fi
  "$finemote" analyze "$source/examples/$name.urdf" --require-static >/dev/null || fail "$name: not static, or not schedulable"
done
"$finemote" analyze "$source/examples/finsrov.urdf.xacro" --require-static >/dev/null || fail "finsrov.urdf.xacro is another robot"
echo "$(ls "$source"/examples/*.timing.json | wc -l) timing files"
