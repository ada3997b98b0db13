#!/usr/bin/env bash
# dev_test.sh FOLDER: what `./dev` says and leaves alone, with stand-ins for the tools that change a machine.
set -euo pipefail
cd "$(dirname "$0")/.."
rm -rf "$1" && mkdir -p "$1/bin"
work=$(cd "$1" && pwd)
cp --parents dev tests/settings_of_users.txt "$work"
cd "$work"

fail() { echo "FAIL: $1"; cat said; exit 1; }

# says STATUS WORDS...: that `./dev WORDS` ends so. What it prints is in said, on stderr alone in progress.
says() {
  local expected=$1 status=0
  shift
  PATH=$work/bin:$PATH ./dev "$@" >result 2>progress || status=$?
  cat result progress >said
  [ "$status" = "$expected" ] || fail "./dev $*: exit status $status"
}

# Nothing is installed, and nothing may be.
printf '#!/bin/sh\nexit 1\n' >bin/dpkg-query
for tool in apt-get sudo cmake ctest; do printf '#!/bin/sh\necho "%s $* $CXXFLAGS" >>"%s/called"\n' $tool "$work" >bin/$tool; done
chmod +x bin/*

says 0 --help
for word in setup build demo test bench golden docs package campaign experiment; do
  grep -q "^  $word  *[a-zA-Z]" result || fail "no help for '$word'"
done
says 2
says 2 nonsense
grep -q "^dev: unknown word 'nonsense'" progress || fail "which word"
says 2 setup test
for word in setup build demo test bench golden docs package campaign experiment; do
  says 2 --no-install $word
  grep -q '^missing packages: .*cmake.*gcc-arm-none-eabi' progress || fail "$word: which packages are missing"
  [ ! -s result ] || fail "$word: no result on stdout"
done
[ ! -e called ] || fail "$(cat called) was called"

# Whatever is missing is installed with one call. No setting of whoever runs this is heard of.
export CXXFLAGS=-theirs
says 0 setup
! grep -e -theirs called || fail "CXXFLAGS reach what is built"
grep -q '^apt-get update' called || fail "no lists"
grep -q '^apt-get install .*cmake.*gcc-arm-none-eabi' called || grep -q '^sudo env .*apt-get install .*cmake.*gcc-arm-none-eabi' called ||
  fail "nothing installed"
grep -q '^cmake --preset host' called || fail "not configured"
