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

seen=0
for case in FM1001 FM3003 FM3008_mux FM3008_unknown_element FM3009 FM3010_missing FM3011 FM3028 FM3030 FM3031 FM3033 FM3035; do
  for robot in "$root"/tests/errors/$case*.urdf; do
    seen=$((seen + 1))
    valid "$robot" && { echo "accepted: $robot"; failed=1; }
  done
done
[ "$seen" -ge 12 ] || { echo "only $seen cases found"; failed=1; }

# mistakes of meaning are none of the schema's business
for robot in "$root"/tests/errors/FM304*.urdf "$root"/tests/errors/FM306*.urdf; do
  valid "$robot" || { echo "refused: $robot"; failed=1; }
done
exit $failed
