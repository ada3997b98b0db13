#!/usr/bin/env bash
# overhead_test.sh FOLDER: the scheduling overhead does not grow unnoticed. The design wants 150 instructions per 10 ms for a ROV of
# 14 devices, which is not reached; a stage's dispatch within 4 is.
set -euo pipefail
counts=$("$(dirname "$0")/overhead.sh" "$1" 2>"$1.log") || { cat "$1.log"; exit 1; }
echo "$counts"
awk '$1 == "total" { total = $2 } $2 == "per" { stage = $4 } END { exit !(total > 0 && total <= 240 && stage > 0 && stage <= 4) }' <<<"$counts"
