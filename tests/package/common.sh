# For the tests of this folder: bash x_test.sh PREFIX WORK, where finemote is installed and what may be written to.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
prefix=$(realpath "$1")
work=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
PATH=$prefix/bin:$PATH
toolchain=$prefix/share/finemote/cmake/toolchain-arm-none-eabi.cmake
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null  # no settings of whoever runs the test
export CCACHE_BASEDIR=  # paths stay as they are in a build without ccache
checks=0

fail() {
  printf 'FAILED %s\n' "$*"
  exit 1
}

# holds WHAT COMMAND...: the command succeeds.
holds() {
  checks=$((checks + 1))
  "${@:2}" >"$work/said" 2>&1 || { tail -n 40 "$work/said"; fail "$1"; }
}

# refuses WHAT PATTERN COMMAND...: the command fails, and what it says without line breaks holds the pattern.
refuses() {
  checks=$((checks + 1))
  if "${@:3}" >"$work/said" 2>&1; then fail "$1: it did not fail"; fi
  tr -s ' \n' ' ' <"$work/said" | grep -q -- "$2" || { cat "$work/said"; fail "$1: no '$2'"; }
}

# equal WHAT SEEN EXPECTED
equal() {
  checks=$((checks + 1))
  [ "$2" = "$3" ] || fail "$1: saw '$2', expected '$3'"
}

# The project of this folder, with its committed sources, as NAME in the work folder.
new_project() {
  cp -r "$here/rover" "$work/$1"
  finemote -q generate "$work/$1/rover.urdf.xacro" period:=20ms -o "$work/$1/generated"
}

# configure_board NAME [options]: its build folder is NAME/build.
configure_board() {
  cmake -G Ninja -S "$work/$1" -B "$work/$1/build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" "${@:2}"
}

rm -rf "$work"
mkdir -p "$work"
trap 'status=$?; [ $status -ne 0 ] || printf "%d checks\n" "$checks"' EXIT
