#!/usr/bin/env bash
# overhead.sh BUILD_DIR : scheduling overhead of a ROV of 14 devices in instructions per 10 ms, split into its parts.
#
# Compiles the images and the counting plugin into BUILD_DIR and runs them on QEMU. The stages of the robot do nothing
# (one instruction each, the return, which is not counted), so what remains is the runtime's. The idle loop is not
# counted. Exact and the same on every run; with Debian 12's compiler these are the documented figures.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=${1:?usage: overhead.sh BUILD_DIR}
mkdir -p "$build"
build=$(cd "$build" && pwd)

api=1
[[ $(qemu-system-arm --version) =~ version\ ([0-9]+) ]] && (( BASH_REMATCH[1] >= 9 )) && api=4
gcc -O2 -shared -fPIC -DPLUGIN_API=$api "$here/instruction_count.c" -o "$build/instruction_count.so"
cmake -G Ninja -S "$here" -B "$build" -DCMAKE_TOOLCHAIN_FILE="$here/../../cmake/toolchain-arm-none-eabi.cmake" >&2
cmake --build "$build" >&2

# counts IMAGE: "<instructions> <function>" for every function of the image
counts() {
  local ranges=() begin size kind name
  while read -r begin size kind name; do
    ranges+=(",range=$begin:$(printf %x $(( 0x$begin + 0x$size ))):$name")
  done < <(arm-none-eabi-nm -S --defined-only "$build/$1.elf" | awk '$3 ~ /[tTwW]/ && NF == 4' | awk '!seen[$1]++')
  timeout 60 qemu-system-arm -M netduinoplus2 -nographic -monitor none -serial none \
    -chardev stdio,id=sh -semihosting-config enable=on,target=native,chardev=sh -icount shift=3,align=off,sleep=off \
    -plugin "$build/instruction_count.so,out=$build/$1.txt$(IFS=; echo "${ranges[*]}")" -kernel "$build/$1.elf" </dev/null >/dev/null
  cat "$build/$1.txt"
}

# per_hyperperiod SUFFIX: the difference of the long and the short run, per 10 ms; without main's idle loop and stages
per_hyperperiod() {
  join -j 2 <(counts "rov14_short$1" | sort -k2) <(counts "rov14_long$1" | sort -k2) |
    awk '$1 != "total" && $1 != "main" && $1 !~ /Empty/ && $1 !~ /4idleEv/ && $3 > $2 { print ($3 - $2) / 100, $1 }' | c++filt -p
}

per_hyperperiod "" > "$build/overhead.txt"
per_hyperperiod "_without_latch" > "$build/overhead_without_latch.txt"
sum() { awk -v pattern="$2" '$2 ~ pattern { sum += $1 } END { print sum + 0 }' "$1"; }

total=$(sum "$build/overhead.txt" .)
release=$(sum "$build/overhead.txt" '^(finemote_release|finemote::board::feed_watchdog)')
entry=$(sum "$build/overhead.txt" '^(finemote_line|Rov14::run_)')
without=$(sum "$build/overhead_without_latch.txt" '^Rov14::rov::')
latch=$(( $(sum "$build/overhead.txt" '^Rov14::rov::') - without ))
echo "total $total"
echo "release $release"
echo "bucket entry $entry"
echo "dispatch $without"
echo "latch $latch"
echo "dispatch per stage $(awk -v n="$without" 'BEGIN { printf "%.2f", n / 30 }')"
