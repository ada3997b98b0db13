#!/usr/bin/env bash
# test.sh FINEMOTE SOURCE: the runner of the cases runs every case of a folder, whatever its name ends in, and fails where a
# script or an answer is missing. Each case leaves a mark when it runs.
set -u
runner=$(dirname "$0")/../run_cases.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/cases" "$folder/ran"
export marks=$folder/ran
unset FINEMOTE_UPDATE_GOLDEN
failed=0
expect() {  # STATUS WHAT COMMAND...
  local wanted=$1 what=$2 status=0
  shift 2
  "$@" >"$folder/said" 2>&1 || status=$?
  [ $status -eq "$wanted" ] || { echo "FAILED $what: exit status $status"; cat "$folder/said"; failed=1; }
}
run() { "$runner" "$1" "$2" "$3" "$folder/cases"; }

for name in FM0001_plain FM0001_overflow FM0001_w FM0001_a_slow FM0001_slow other_case; do
  echo "touch \$marks/$name; echo '[FM0001]'" >"$folder/cases/$name.sh"
  printf -- '-- stdout\n[FM0001]\n-- exit 0\n' >"$folder/cases/$name.expected"
done
expect 0 'quick cases' run "$1" "$2" quick
expect 0 'slow cases' run "$1" "$2" slow
diff <(cd "$folder/cases" && ls *.sh | sed 's/\.sh$//') <(ls "$folder/ran") || { echo 'FAILED: a case does not run'; failed=1; }

rm "$folder/cases/FM0001_w.expected"
expect 1 'a case without its answer' run "$1" "$2" quick
rm "$folder/cases/FM0001_w.sh" "$folder/cases/FM0001_slow.sh"
expect 0 'the other cases' run "$1" "$2" quick
expect 1 'an answer without its case' run "$1" "$2" slow
[ $failed -eq 0 ] && echo 'every case runs'
exit $failed
