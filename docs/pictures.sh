#!/usr/bin/env bash
# pictures.sh FINEMOTE [--dry-run]: draws the pictures of device trees in docs/pictures. With --dry-run nothing is written, and the
# exit status is 1 where a picture is not what would be drawn.
set -euo pipefail
finemote=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
status=0
for robot in finsrov infantry; do
  drawn=$("$finemote" graph "../examples/$robot.urdf")
  if [ "${2:-}" = --dry-run ]; then
    cmp -s "pictures/$robot.svg" <(printf '%s\n' "$drawn") || { echo "stale: docs/pictures/$robot.svg"; status=1; }
  else
    printf '%s\n' "$drawn" >"pictures/$robot.svg"
  fi
done
exit $status
