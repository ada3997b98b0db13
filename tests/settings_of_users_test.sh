#!/usr/bin/env bash
# settings_of_users_test.sh CTEST BUILD: what ctest runs sees no settings of whoever started it; BUILD is where the tests' are.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { printf 'FAILED %s\n' "$*"; exit 1; }

# The line by which ctest knows of the settings, and one test that shows its environment.
grep 'no_settings.cmake' "$2/CTestTestfile.cmake" >"$work/CTestTestfile.cmake" || fail "ctest does not include no_settings.cmake"
echo 'add_test(environment env)' >>"$work/CTestTestfile.cmake"
mapfile -t names <"$here/settings_of_users.txt"
[ ${#names[@]} -ge 10 ] || fail "only ${#names[@]} names"
env "${names[@]/%/=theirs}" HAVE_BEEN=here "$1" --test-dir "$work" -V >"$work/said" || fail "ctest: $(cat "$work/said")"
grep -q 'HAVE_BEEN=here' "$work/said" || fail "the environment is not shown"
! grep '=theirs' "$work/said" || fail "a setting is seen"

# The same for a script that runs by itself.
! env "${names[@]/%/=theirs}" bash -c '. "$1/common.sh"; env' - "$here" | grep '=theirs' || fail "a script sees a setting"
echo "${#names[@]} settings are not seen"
