#!/usr/bin/env bash
# usage: ends_with.sh STATUS TEXT COMMAND...
# Whether the command ends with this exit status and says this text. PASS_REGULAR_EXPRESSION of CTest looks at the text
# alone. TEXT is an extended regular expression; one blank in it stands for any blanks and line ends.
set -uo pipefail
status=$1 text=$2
shift 2
output=$("$@" 2>&1)
found=$?
printf '%s\n' "$output"
[ "$found" -eq "$status" ] || { echo "exit status $found instead of $status" >&2; exit 1; }
tr -s '[:space:]' ' ' <<<"$output" | grep -qE -- "$text" || { echo "does not say: $text" >&2; exit 1; }
