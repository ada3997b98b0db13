#!/usr/bin/env bash
# The XSD accepts every example, and refuses those mistakes a schema can see. Exit 77: xmllint is not installed.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
command -v xmllint >/dev/null || exit 77
valid() { xmllint --noout --nonet --schema "$root/schemas/finemote.xsd" "$1" >/dev/null 2>&1; }
failed=0

for robot in "$root"/examples/*.urdf "$root"/examples/*.xacro; do
  [ -e "$robot" ] || continue
  valid "$robot" || { echo "refused: $robot"; xmllint --noout --schema "$root/schemas/finemote.xsd" "$robot" 2>&1 | head -5; failed=1; }
done

# Every robot of this folder: a schema sees form, not meaning. Names of cases, or their beginnings.
visible='FM1001 FM2005_sdf FM3003 FM3008_mux FM3008_outside FM3008_unknown_element FM3009 FM3010_free_name FM3010_missing FM3011_bus_type FM3011_expander_as_bus FM3028 FM3030 FM3031_wrong FM3032
  FM3033 FM3035 FM3036 FM3061_8bit FM3062 combined'
seen=0
for robot in "$root"/tests/errors/*.urdf; do
  name=$(basename "$robot" .urdf)
  is_visible=no
  for case in $visible; do
    case $name in "$case"*) is_visible=yes; seen=$((seen + 1)) ;; esac
  done
  if valid "$robot"; then
    [ $is_visible = no ] || { echo "accepted: $name"; failed=1; }
  else
    [ $is_visible = yes ] || { echo "refused: $name"; xmllint --noout --nonet --schema "$root/schemas/finemote.xsd" "$robot" 2>&1 | head -3; failed=1; }
  fi
done
[ "$seen" -ge 17 ] || { echo "only $seen cases found"; failed=1; }
exit $failed
