#!/usr/bin/env bash
# On the computer: device tests and robots build without a warning with the compilers of Debian 12, one with optimisation and one
# without, and pass.
. "$(dirname "$0")/common.sh"
new_project rover
for built in "g++ Release" "clang++ Debug"; do
  read -r compiler type <<<"$built"
  what="$compiler, build type '$type'"
  build=$work/build-$compiler
  holds "$what: configures" cmake -G Ninja -S "$work/rover" -B "$build" -DCMAKE_CXX_COMPILER=$compiler \
    -DCMAKE_BUILD_TYPE="$type" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Wshadow"
  holds "$what: builds" ninja -C "$build"
  ! grep -i "warning" "$work/said" || fail "$what: a warning"
  holds "$what: passes" ctest --test-dir "$build" --output-on-failure --no-tests=error
  holds "$what: the robot runs" "$build/rover"
done
